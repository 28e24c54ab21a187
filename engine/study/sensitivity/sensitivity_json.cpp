#include "engine/study/sensitivity/sensitivity_json.h"

#include <cmath>
#include <stdexcept>

#include "engine/base/parse_json.h"
#include "engine/study/sensitivity/sensitivity_members.h"
#include "engine/study/study_record.h"

namespace plumb {
namespace {

constexpr int sensitivity_version = 1;

void check(const Sensitivity& found) {
  const std::size_t criteria = found.criteria.size();
  if (!(found.largest > 1 && std::isfinite(found.largest)))
    throw std::runtime_error("its largest factor is no number above 1");
  for (const NumberSensitivity& number : found.numbers)
    for (const SearchedSide* side : {&number.up, &number.down}) {
      if (side->noticed.size() != criteria)
        throw std::runtime_error("it does not say of each criterion what it notices");
      for (const NoticedChange& noticed : side->noticed)
        if (!std::isfinite(noticed.change)) throw std::runtime_error("a change is not finite");
    }
  for (const BlunderSensitivity& blunder : found.blunders)
    if (blunder.trial.found.size() != (blunder.trial.outcome == Outcome::completed ? criteria : 0))
      throw std::runtime_error("it does not say of each criterion what it finds");
}

}  // namespace

std::string encode_sensitivity(const SensitivityStudy& study) {
  return encode_study_record(
      "sensitivity", sensitivity_version, study.loaded.source,
      {{"sensitivity", encode(study.result)}, {"provenance", encode(study.provenance)}});
}

SensitivityStudy decode_sensitivity(const std::string& text, const std::string& file) {
  StudyRecord record = decode_study_record(text, file, "sensitivity", sensitivity_version);
  try {
    SensitivityStudy study{std::move(record.loaded), {}, {}};
    decode(record.body.at("sensitivity"), study.result);
    decode(record.body.at("provenance"), study.provenance);
    check(study.result);
    return study;
  } catch (...) {
    refuse_unusable(file);
  }
}

}  // namespace plumb
