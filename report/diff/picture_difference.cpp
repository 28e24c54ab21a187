#include "report/diff/picture_difference.h"

#include <fmt/format.h>

#include "engine/base/message.h"
#include "render/image/apng_player.h"
#include "render/image/png.h"

namespace plumb {
namespace {

std::string in_words(const ImageDifference& found, const DifferenceTolerance& tolerance) {
  return fmt::format(
      "{} pixels differ, by up to {} levels; {} by more than {}, at most {:.3g} % of a window of {} pixels, "
      "at ({}, {}); {:.3g} % are allowed",
      found.changed, found.greatest, found.beyond, tolerance.channel, 100 * found.density, difference_window,
      found.x, found.y, 100 * tolerance.density);
}

std::string times_in_words(std::uint32_t plays) {
  return plays == 0 ? "without end" : fmt::format("{} times", plays);
}

std::string frames_in_words(const PngFile& file) {
  if (!file.says_animated) return "a still picture";
  return file.frames.empty() ? "an animation without frames" : fmt::format("{} frames", file.frames.size());
}

bool same_delay(const PngFrame& a, const PngFrame& b) {
  return std::uint64_t{a.delay} * b.delay_unit == std::uint64_t{b.delay} * a.delay_unit;
}

/// What two files differ in before a pixel is looked at; empty: nothing.
std::string difference_of_kind(const PngFile& a, const PngFile& b) {
  if (a.width != b.width || a.height != b.height)
    return fmt::format("{} x {} and {} x {} pixels", a.width, a.height, b.width, b.height);
  if (a.color_space != b.color_space)
    return "the same pixels are seen otherwise: cICP, iCCP, sRGB, gAMA, cHRM or eXIf differ";
  if (frames_in_words(a) != frames_in_words(b))
    return fmt::format("{} and {}", frames_in_words(a), frames_in_words(b));
  if (!a.frames.empty() && a.plays != b.plays)
    return fmt::format("played {} and {}", times_in_words(a.plays), times_in_words(b.plays));
  for (std::size_t k = 0; k < a.frames.size(); ++k) {
    const PngFrame &one = a.frames[k], &other = b.frames[k];
    if (!same_delay(one, other))
      return fmt::format("frame {}: shown for {}/{} and {}/{} s", k, one.delay, one.delay_unit, other.delay,
                         other.delay_unit);
  }
  return {};
}

/// What drew two pictures, where that is not the same: only in what they differ. Empty: neither says it.
std::string renderers_in_words(const std::optional<std::string>& a, const std::optional<std::string>& b) {
  if (!a && !b) return "";
  constexpr std::size_t longest = 200;
  const auto shown = [](const std::optional<std::string>& one) {
    return one ? one_line(*one).substr(0, longest) : std::string("what is not said");
  };
  return fmt::format("drawn by {} and by {}: ", shown(a), shown(b));
}

bool same_data(const PngFile& a, const std::vector<std::string_view>& data_of_a, const PngFile& b,
               const std::vector<std::string_view>& data_of_b) {
  return a.header == b.header && a.palette == b.palette && a.opacity == b.opacity && data_of_a == data_of_b;
}

/// Holds pairs of pictures against each other and keeps the worst.
class WorstDifference {
 public:
  WorstDifference(const DifferenceTolerance& tolerance, bool to_the_byte, bool show)
      : tolerance_(tolerance), to_the_byte_(to_the_byte), show_(show) {}

  void compare(const std::string& what, const PngPixels& a, const PngPixels& b) {
    const ImageDifference found = difference(a.image, b.image, tolerance_);
    if (found.changed == 0 && a.finer == b.finer) return;
    // What 8 bits cannot tell is less than one level, and more than none.
    const bool within = found.within(tolerance_) && (a.finer == b.finer || tolerance_.channel > 0);
    const Sameness sameness = !to_the_byte_ && within ? Sameness::within : Sameness::different;
    const bool worse = result.sameness == Sameness::identical ||
                       (sameness == Sameness::different && result.sameness == Sameness::within) ||
                       (sameness == result.sameness && found.density > result.number);
    if (!worse) return;
    result.sameness = sameness;
    result.number = found.density;
    result.in_words = what + (found.changed > 0 ? in_words(found, tolerance_)
                                                : "pixels differ by less than 8 bits a channel can tell");
    if (to_the_byte_) result.in_words += "; the same renderer must give the same bytes";
    if (!show_) return;
    result.first = encode_png(a.image);
    result.second = encode_png(b.image);
    result.marks = encode_png(difference_image(a.image, b.image, tolerance_));
  }

  FileDifference result{{}, Sameness::identical, 0, "the same pixels", {}, {}, {}};

 private:
  DifferenceTolerance tolerance_;
  bool to_the_byte_;
  bool show_;
};

}  // namespace

FileDifference compare_pictures(const std::string& a, const std::string& name_a, const std::string& b,
                                const std::string& name_b, const DifferenceOptions& options) {
  const PngFile first = read_png_file(a, name_a), second = read_png_file(b, name_b);
  if (const std::string kind = difference_of_kind(first, second); !kind.empty())
    return {{}, Sameness::different, -1, kind, {}, {}, {}};
  const DifferenceTolerance defaults;
  const auto drawn_by = text_in_png(a, renderer_keyword, name_a),
             other_by = text_in_png(b, renderer_keyword, name_b);
  const bool same_renderer = drawn_by && drawn_by == other_by;
  WorstDifference all(
      {options.channel.value_or(defaults.channel), options.density.value_or(defaults.density)},
      same_renderer && !options.channel && !options.density, options.pictures);
  // Where it is a frame of both, it is compared as that.
  const bool still = first.frames.empty() || !first.still_is_frame || !second.still_is_frame;
  if (still && !same_data(first, first.data, second, second.data))
    all.compare(first.frames.empty() ? "" : "the still picture, for programs that show no animation: ",
                decode_still(first, name_a), decode_still(second, name_b));
  ApngPlayer one(first, name_a), other(second, name_b);
  for (std::size_t k = 0; k < first.frames.size(); ++k) {
    const PngFrame &frame = first.frames[k], &its = second.frames[k];
    const bool alone = stands_alone(first, frame) && stands_alone(second, its);
    if (alone && same_data(first, frame.data, second, its.data)) continue;
    all.compare(first.frames.size() > 1 ? fmt::format("frame {}: ", k) : "", one.show(k), other.show(k));
  }
  if (!same_renderer && all.result.sameness != Sameness::identical)
    all.result.in_words = renderers_in_words(drawn_by, other_by) + all.result.in_words;
  return std::move(all.result);
}

}  // namespace plumb
