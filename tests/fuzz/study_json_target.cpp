#include <nlohmann/json.hpp>

#include "engine/study/economy/economy_study_json.h"
#include "engine/study/economy/run_economy.h"
#include "engine/study/sensitivity/sensitivity_json.h"
#include "engine/study/stability/stability_file.h"
#include "engine/study/sweep/sweep_json.h"
#include "engine/study/variants/variants_file.h"
#include "report/program/study_kinds.h"
#include "tests/fuzz/target.h"
#include "tests/report/study/made_studies.h"
#include "tests/report/study/stability/made_stability.h"

namespace plumb::fuzz {
namespace {

std::string again(const std::string& text, std::string_view kind) {
  if (kind == "stability") return encode_stability(decode_stability(text, "study.json"));
  if (kind == "variants") return encode_variants(decode_variants(text));
  if (kind == "sweep") return encode_sweep(decode_sweep(text, "study.json"));
  if (kind == "sensitivity") return encode_sensitivity(decode_sensitivity(text, "study.json"));
  return encode_economy_study(decode_economy_study(text, "study.json"));
}

bool feed(std::string_view input) {
  const std::string text(input);
  return reads<InputError>([&] {
    const std::string kind = kind_of_study_json({"study.json", text}).name;
    const std::string written = again(text, kind);
    promise(again(written, kind) == written, "a study that is written and read again is another: " + kind);
  });
}

std::vector<std::string> seeds() {
  return {encode_stability(made_stability_file()), encode_sweep(made_sweep()),
          encode_variants(made_variants()), encode_economy_study(made_economy_study()),
          encode_sensitivity(made_sensitivity())};
}

}  // namespace

const Target study_json_target{"study_json", feed, seeds};

}  // namespace plumb::fuzz
