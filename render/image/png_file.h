#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

/// Pixels along a side, and in all, of a picture that is read.
inline constexpr std::uint32_t most_png_side = 32768;
inline constexpr double most_png_pixels = 1.5e8;
/// Pixels of all frames of an animation that is read.
inline constexpr double most_apng_pixels = 1e11;

/// What becomes of a frame before the next one is drawn.
enum class FrameAfter { stays, is_cleared, is_undone };

/// A frame of an animated PNG, as its fcTL chunk has it.
struct PngFrame {
  int x = 0, y = 0, width = 0, height = 0;  ///< pixels, within the picture
  std::uint32_t delay = 0;                  ///< it is shown for delay / delay_unit seconds
  std::uint32_t delay_unit = 100;           ///< > 0
  FrameAfter after = FrameAfter::stays;
  bool blends = false;                      ///< with what it covers; else it replaces that, opacity and all
  std::vector<std::string_view> data = {};  ///< compressed pixels
};

/// The parts of a PNG file that say how it is seen, as views into its bytes.
struct PngFile {
  int width = 0, height = 0;  ///< pixels
  std::string_view header;    ///< of IHDR
  std::string_view palette;   ///< of PLTE; empty: none
  std::string_view opacity;   ///< of tRNS; empty: none
  /// The chunks that change in what colours, or which way up, its pixels are seen; empty: as sRGB.
  std::string color_space;
  std::vector<std::string_view> data;  ///< compressed pixels of the still picture
  bool says_animated = false;          ///< it has an acTL
  std::uint32_t plays = 0;             ///< of the animation; 0: without end
  bool still_is_frame = false;         ///< the still picture is the first frame
  std::vector<PngFrame> frames;        ///< none: what says it is animated is shown as its still picture
};

/// Reads the parts of a PNG file and checks them against PNG, third edition: what chunks there are, their
/// order, their sequence numbers, and that every frame lies within the picture. Nothing is decoded. Throws
/// InputError that names `name` for a file that is not so, and for one of more pixels than is read here or
/// than its data can hold.
PngFile read_png_file(std::string_view bytes, const std::string& name);
/// Not of a temporary, which the views would outlive.
PngFile read_png_file(std::string&& bytes, const std::string& name) = delete;

}  // namespace plumb
