#include "engine/study/study_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "engine/base/document_sum.h"
#include "engine/base/errors.h"
#include "engine/base/message.h"
#include "engine/base/parse_json.h"
#include "engine/run/case_source_json.h"

namespace plumb {

std::string encode_study_record(const char* kind, int version, const CaseSource& source,
                                const nlohmann::ordered_json& body) {
  nlohmann::ordered_json json{{"kind", kind}, {"version", version}, {"case", case_source_to_json(source)}};
  json.update(body);
  return to_summed_text(std::move(json), -1);
}

SectionUse uses_of_study(std::string_view kind) {
  std::string own = fmt::format("study.{}", kind == "variants" ? "variant" : kind);
  std::replace(own.begin(), own.end(), '-', '_');
  return [own, kind = std::string(kind)](std::string_view section) {
    return section == own || section == kind || section == "scene";
  };
}

StudyRecord decode_study_record(const std::string& text, const std::string& file, const char* kind,
                                int version, int oldest) {
  try {
    auto json = parse_json<nlohmann::ordered_json>(text, file);
    if (json.at("kind") != kind) throw std::runtime_error(fmt::format("it is no study of the kind {}", kind));
    if (const long stored = json.at("version").get<long>(); stored < oldest || stored > version)
      throw std::runtime_error(fmt::format(
          "its version is {}, this program reads {}", stored,
          oldest == version ? fmt::format("{}", version) : fmt::format("{} to {}", oldest, version)));
    const CaseSource source = case_source_from_json(json.at("case"));
    try {
      return {load_case(source, uses_of_study(kind)), std::move(json)};
    } catch (const InputError& error) {
      throw InputError(one_line(fmt::format("{}: the case in it is invalid: {}", file, error.what())));
    }
  } catch (...) {
    refuse_unusable(file);
  }
}

}  // namespace plumb
