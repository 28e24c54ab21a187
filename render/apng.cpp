#include "render/apng.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

#include "engine/errors.h"
#include "render/png_chunks.h"

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
  constexpr std::size_t sequence_size = 4, size_begin = 4, size_end = 12, place_end = 20;
  std::string head(png_signature);
  std::string_view size;
  std::vector<std::string> frames;
  bool animated = false;
  for (const PngChunk& chunk : png_chunks(bytes, name)) {
    if (chunk.type == "IHDR") {
      append_chunk(head, chunk.type, chunk.data);
      size = chunk.data.substr(0, 8);
    } else if (chunk.type == "acTL") {
      animated = true;
    } else if (chunk.type == "fcTL") {
      if (chunk.data.size() < place_end || chunk.data.substr(size_begin, size_end - size_begin) != size ||
          chunk.data.substr(size_end, place_end - size_end) != std::string_view("\0\0\0\0\0\0\0\0", 8))
        throw InputError(fmt::format("{}: frame {} is but a part of the picture", name, frames.size() + 1));
      frames.push_back(head);
    } else if (chunk.type == "IDAT" && !frames.empty()) {
      append_chunk(frames.back(), chunk.type, chunk.data);
    } else if (chunk.type == "fdAT" && !frames.empty() && chunk.data.size() >= sequence_size) {
      append_chunk(frames.back(), "IDAT", chunk.data.substr(sequence_size));
    }
  }
  if (!animated) return {bytes};
  for (std::string& frame : frames) append_chunk(frame, "IEND", {});
  return frames;
}

}  // namespace plumb
