#include "engine/study/sweep/sweep_json.h"

#include <fmt/format.h>

#include <stdexcept>

#include "engine/base/parse_json.h"
#include "engine/study/study_record.h"
#include "engine/study/sweep/sweep_members.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

// Version 1 had null for all that is not finite, and is no longer read.
constexpr int sweep_version = 2;

void check(const Sweep& sweep) {
  if (!(sweep.spec.tolerance > 0)) throw std::runtime_error("its tolerance is not greater than 0");
  if (std::ssize(sweep.runs) != sweep.spec.cases)
    throw std::runtime_error(fmt::format("it has {} runs of {} cases", sweep.runs.size(), sweep.spec.cases));
  for (std::size_t k = 0; k < sweep.runs.size(); ++k)
    if (sweep.runs[k].number != static_cast<long>(k))
      throw std::runtime_error(fmt::format("run {} has the number {}", k, sweep.runs[k].number));
}

}  // namespace

Json sweep_run_json(const SweepRun& run) {
  return encode(run, NotFinite::null);
}

std::string encode_sweep(const Sweep& sweep) {
  Json body{{"title", sweep.loaded.spec.title}};
  body.update(encode(sweep.spec));
  body["provenance"] = encode(sweep.provenance);
  body["runs"] = encode(sweep.runs);
  return encode_study_record("sweep", sweep_version, sweep.loaded.source, body);
}

Sweep decode_sweep(const std::string& json, const std::string& file) {
  StudyRecord record = decode_study_record(json, file, "sweep", sweep_version, sweep_version);
  try {
    Sweep sweep;
    sweep.loaded = std::move(record.loaded);
    decode(record.body, sweep.spec);
    decode(record.body.at("runs"), sweep.runs);
    decode(record.body.at("provenance"), sweep.provenance);
    check(sweep);
    return sweep;
  } catch (...) {
    refuse_unusable(file);
  }
}

}  // namespace plumb
