#include <nlohmann/json.hpp>

#include "engine/case/case_source.h"
#include "engine/read/uncertain_keys.h"
#include "engine/run/case_source_json.h"
#include "tests/fuzz/small_files.h"

namespace plumb::fuzz {
namespace {

void promise_case(const Case& spec, bool has_method) {
  const CableSpec& cable = spec.cable;
  promise_finite({{cable.length, cable.area, cable.density, cable.youngs_modulus, cable.second_moment}},
                 "a number of [cable]");
  promise(cable.length > 0 && cable.area > 0 && cable.density > 0 && cable.youngs_modulus > 0,
          "a cable of nothing");
  promise(cable.elements >= (has_method ? 1 : 0) && cable.elements <= 1'000'000, "elements out of range");
  promise_finite({{spec.time.end, spec.time.output_interval}}, "a time");
  promise(spec.time.end > 0, "a run of no time");
  if (has_method)
    promise(spec.time.output_interval > 0 && spec.time.output_interval <= spec.time.end,
            "an interval out of range");
  for (const Vec3& vector :
       {spec.start.direction, spec.start.angular_velocity, spec.loads.gravity, spec.loads.end_force})
    promise(vector.allFinite(), "a vector is not finite");
  promise(std::abs(spec.start.direction.norm() - 1) < 1e-9, "the direction is no unit vector");
  for (const auto& [name, value] : spec.parameters) promise_finite({{value}}, "parameters." + name);
  for (const ProbeSpec& one : spec.probes) promise(one.at >= 0 && one.at <= 1, "a probe beside the cable");
  for (const ReferenceUse& use : spec.references)
    promise(use.tolerance > 0 && std::isfinite(use.tolerance), "a tolerance of nothing");
  for (const int side : spec.scene.size) promise(side >= 16 && side <= 32768, "a picture out of range");
  for (const std::string& key : uncertain_keys(spec))
    promise(uncertain_value(spec, key).has_value(), key + " has no value");
}

bool feed(std::string_view input) {
  CaseSource source = small_source();
  source.file.text = input;
  return reads<InputError>([&] {
    const LoadedCase loaded = load_case(source);
    promise_case(loaded.spec, !loaded.spec.method.name.empty());
    promise(load_case(loaded.source).spec == loaded.spec, "a case read from its own texts is another");
    const auto json = case_source_to_json(loaded.source);
    const CaseSource back = case_source_from_json(nlohmann::ordered_json::parse(json.dump()));
    promise(back.file.text == loaded.source.file.text, "the text of a case in JSON is another");
  });
}

std::vector<std::string> seeds() {
  std::vector<std::string> texts{small_source().file.text, small_given_case()};
  for (std::string& text : shelf_texts()) texts.push_back(std::move(text));
  return texts;
}

}  // namespace

const Target case_target{"case", feed, seeds};

}  // namespace plumb::fuzz
