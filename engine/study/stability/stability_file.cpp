#include "engine/study/stability/stability_file.h"

#include "engine/base/parse_json.h"
#include "engine/study/stability/stability_json.h"
#include "engine/study/study_record.h"

namespace plumb {
namespace {

constexpr int stability_version = 1;

}  // namespace

std::string encode_stability(const StabilityStudyFile& study) {
  return encode_study_record(stability_kind, stability_version, study.loaded.source,
                             {{"result", stability_to_json(study.result)}});
}

StabilityStudyFile decode_stability(const std::string& text, const std::string& name) {
  StudyRecord record = decode_study_record(text, name, stability_kind, stability_version);
  try {
    return {std::move(record.loaded), stability_from_json(record.body.at("result"))};
  } catch (...) {
    refuse_unusable(name);
  }
}

}  // namespace plumb
