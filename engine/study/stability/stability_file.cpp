#include "engine/study/stability/stability_file.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "engine/base/document_sum.h"
#include "engine/base/errors.h"
#include "engine/base/message.h"
#include "engine/base/parse_json.h"
#include "engine/run/case_source_json.h"
#include "engine/study/stability/stability_json.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

constexpr long version = 1;

StabilityStudyFile study_of(const Json& json) {
  if (json.at("kind") != stability_kind) throw std::runtime_error("it is no stability study");
  if (json.at("version").get<long>() > version)
    throw std::runtime_error(fmt::format("its version {} is beyond what this program reads, {}",
                                         json.at("version").get<long>(), version));
  return {load_case(case_source_from_json(json.at("case"))), stability_from_json(json.at("result"))};
}

}  // namespace

std::string encode_stability(const StabilityStudyFile& study) {
  Json json{{"kind", stability_kind},
            {"version", version},
            {"case", case_source_to_json(study.loaded.source)},
            {"result", stability_to_json(study.result)}};
  return to_summed_text(std::move(json), -1);
}

StabilityStudyFile decode_stability(const std::string& text, const std::string& name) {
  const Json json = parse_json<Json>(text, name);
  try {
    return study_of(json);
  } catch (const InputError& error) {
    throw InputError(one_line(fmt::format("{}: the case in it is invalid: {}", name, error.what())));
  } catch (...) {
    refuse_unusable(name);
  }
}

}  // namespace plumb
