#include "engine/run/case_source_json.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

namespace plumb {
namespace {

constexpr unsigned ascii_end = 0x80, low_bits = 0x3F, lead_of_two = 0xC0, continuation = 0x80;

std::string bytes_to_text(const std::string& bytes) {
  std::string text;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < ascii_end) {
      text += c;
      continue;
    }
    text += static_cast<char>(lead_of_two | (byte >> 6U));
    text += static_cast<char>(continuation | (byte & low_bits));
  }
  return text;
}

std::string text_to_bytes(const std::string& text) {
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto lead = static_cast<unsigned char>(text[i]);
    if (lead < ascii_end) {
      bytes += text[i];
      continue;
    }
    // Of two bytes, the greatest lead that is still a byte is 0xC3.
    if ((lead & ~3U) != lead_of_two || i + 1 == text.size())
      throw std::runtime_error("the file of a run has a character that is no byte");
    bytes += static_cast<char>(((lead & 3U) << 6U) | (static_cast<unsigned char>(text[++i]) & low_bits));
  }
  return bytes;
}

nlohmann::ordered_json text_json(const NamedText& text) {
  return {{"name", text.name}, {"text", text.text}};
}

NamedText text_of(const nlohmann::ordered_json& json) {
  return {json.at("name").get<std::string>(), json.at("text").get<std::string>()};
}

}  // namespace

nlohmann::ordered_json case_source_to_json(const CaseSource& source) {
  nlohmann::ordered_json json{{"file", text_json(source.file)},
                              {"overrides", source.overrides},
                              {"references", nlohmann::ordered_json::array()}};
  for (const NamedText& reference : source.references) json["references"].push_back(text_json(reference));
  for (const NamedText& run : source.given_runs)
    json["runs"].push_back(text_json({run.name, bytes_to_text(run.text)}));
  return json;
}

CaseSource case_source_from_json(const nlohmann::ordered_json& json) {
  CaseSource source{text_of(json.contains("file") ? json.at("file") : json),
                    json.at("overrides").get<std::vector<std::string>>(),
                    {}};
  for (const nlohmann::ordered_json& reference : json.at("references"))
    source.references.push_back(text_of(reference));
  if (json.contains("runs"))
    for (const nlohmann::ordered_json& run : json.at("runs")) {
      const NamedText text = text_of(run);
      source.given_runs.push_back({text.name, text_to_bytes(text.text)});
    }
  return source;
}

}  // namespace plumb
