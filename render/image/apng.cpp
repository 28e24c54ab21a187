#include "render/image/apng.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

#include "engine/base/errors.h"
#include "render/image/apng_player.h"
#include "render/image/png_chunks.h"

namespace plumb {

namespace {

void append_u16(std::string& out, unsigned value) {
  out.push_back(static_cast<char>((value >> 8) & 255U));
  out.push_back(static_cast<char>(value & 255U));
}

// How long a frame is shown, as the fraction of a second that fcTL holds.
struct Delay {
  unsigned numerator;
  unsigned denominator;
};

Delay delay(double frame_rate) {
  constexpr double largest = 65535;
  if (frame_rate >= 1 && frame_rate <= largest && frame_rate == std::round(frame_rate))
    return {1, static_cast<unsigned>(frame_rate)};
  const double milliseconds = std::round(1000 / frame_rate);
  if (!(frame_rate > 0) || !(milliseconds >= 1) || milliseconds > largest)
    throw OutputError(
        fmt::format("animated PNG: {} frames a second: must be in [0.0153, 2000] or whole", frame_rate));
  return {static_cast<unsigned>(milliseconds), 1000};
}

}  // namespace

std::string join_apng(std::span<const std::string> frames, double frame_rate) {
  if (frames.empty()) throw OutputError("animated PNG: no frames");
  const Delay shown = delay(frame_rate);
  std::string out(png_signature);
  std::string_view header;
  std::uint32_t sequence = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    bool controlled = false;
    for (const PngChunk& chunk : png_chunks(frames[i], fmt::format("frame {}", i))) {
      if (chunk.type == "IHDR") {
        if (i == 0) {
          header = chunk.data;
          append_chunk(out, "IHDR", header);
          std::string control;
          append_u32(control, static_cast<std::uint32_t>(frames.size()));
          append_u32(control, 0);  // plays: without end
          append_chunk(out, "acTL", control);
        } else if (chunk.data != header) {
          throw OutputError(fmt::format("animated PNG: frame {} differs from the first in size or kind", i));
        }
      } else if (chunk.type == "IDAT") {
        if (!controlled) {
          std::string control;
          append_u32(control, sequence++);
          control.append(header.substr(0, 8));  // width and height
          append_u32(control, 0);               // left
          append_u32(control, 0);               // top
          append_u16(control, shown.numerator);
          append_u16(control, shown.denominator);
          append_u16(control, 0);  // keep what is shown, replace it by the next
          append_chunk(out, "fcTL", control);
          controlled = true;
        }
        if (i == 0) {
          append_chunk(out, "IDAT", chunk.data);
        } else {
          std::string data;
          append_u32(data, sequence++);
          data.append(chunk.data);
          append_chunk(out, "fdAT", data);
        }
      } else if (i == 0 && chunk.type != "IEND") {
        append_chunk(out, chunk.type, chunk.data);
      }
    }
  }
  append_chunk(out, "IEND", {});
  return out;
}

std::vector<std::string> split_apng(const std::string& bytes, const std::string& name) {
  const PngFile file = read_png_file(bytes, name);
  if (!file.says_animated) return {bytes};
  if (file.frames.empty()) throw InputError(name + ": is said to be an animation and has no frames");
  std::vector<std::string> frames;
  for (const PngFrame& frame : file.frames) {
    if (!stands_alone(file, frame))
      throw InputError(fmt::format("{}: frame {} is but a part of the picture", name, frames.size() + 1));
    frames.push_back(png_of_frame(file, frame));
  }
  return frames;
}

}  // namespace plumb
