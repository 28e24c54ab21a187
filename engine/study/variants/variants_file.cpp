#include "engine/study/variants/variants_file.h"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "engine/base/document_sum.h"
#include "engine/base/errors.h"
#include "engine/base/message.h"
#include "engine/base/parse_json.h"
#include "engine/run/case_source_json.h"
#include "engine/run/stored_parts.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

struct EnergyPart {
  const char* name;
  double Energies::*value;
};
constexpr EnergyPart energy_parts[] = {{"kinetic", &Energies::kinetic},
                                       {"axial", &Energies::axial},
                                       {"bending", &Energies::bending},
                                       {"potential", &Energies::potential}};

Json variant_json(const VariantResult& variant) {
  const Trajectory& t = variant.trajectory;
  Json json{{"name", variant.spec.name},
            {"outcome", word(t.outcome)},
            {"message", t.message},
            {"elements", t.elements},
            {"element_length", t.element_length},
            {"end_time", t.end_time},
            {"solve_seconds", t.solve_seconds},
            {"constraint_drift", t.constraint_drift},
            {"interpolated_outputs", t.interpolated_outputs}};
  for (const auto& [name, part] : stored_counters()) json["counters"][name] = t.counters.*part;
  json["time"] = t.times;
  for (const EnergyPart& part : energy_parts) {
    json["energy"][part.name] = Json::array();
    for (const Energies& energies : t.energies) json["energy"][part.name].push_back(energies.*part.value);
  }
  json["probes"] = Json::array();
  for (const Column& column : variant.probes.columns)
    json["probes"].push_back({{"name", column.name}, {"unit", column.unit}, {"values", column.values}});
  json["figures"] = Json::array();
  for (const ExpectationFound& figure : variant.expectations)
    json["figures"].push_back(
        {{"quantity", figure.expected.quantity}, {"unit", figure.unit}, {"found", figure.found}});
  return json;
}

double number(const Json& json) {
  return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

std::vector<double> numbers(const Json& json, std::size_t count, const char* what) {
  std::vector<double> values;
  for (const Json& value : json) values.push_back(number(value));
  if (!json.is_array() || values.size() != count)
    throw std::runtime_error(fmt::format("its {} are not one an output", what));
  return values;
}

VariantResult variant_of(const Json& json, const VariantSpec& spec, const CaseSource& source) {
  VariantResult variant;
  variant.spec = spec;
  variant.run = load_variant(source, spec).spec;
  if (json.at("name").get<std::string>() != spec.name)
    throw std::runtime_error("its variants are not those of its case");
  Trajectory& t = variant.trajectory;
  t.outcome = stored_outcome(json.at("outcome").get<std::string>());
  t.message = one_line(json.at("message").get<std::string>());
  t.elements = json.at("elements").get<int>();
  t.element_length = number(json.at("element_length"));
  t.end_time = number(json.at("end_time"));
  t.solve_seconds = number(json.at("solve_seconds"));
  t.constraint_drift = number(json.at("constraint_drift"));
  t.interpolated_outputs = json.at("interpolated_outputs").get<int>();
  for (const auto& [name, part] : stored_counters())
    t.counters.*part = json.at("counters").at(name).get<long>();
  t.times = numbers(json.at("time"), json.at("time").size(), "times");
  t.energies.resize(t.times.size());
  for (const EnergyPart& part : energy_parts) {
    const auto values = numbers(json.at("energy").at(part.name), t.times.size(), "energies");
    for (std::size_t k = 0; k < values.size(); ++k) t.energies[k].*part.value = values[k];
  }
  variant.probes.times = t.times;
  for (const Json& column : json.at("probes"))
    variant.probes.columns.push_back({column.at("name").get<std::string>(),
                                      column.at("unit").get<std::string>(),
                                      numbers(column.at("values"), t.times.size(), "probes")});
  const Json& figures = json.at("figures");
  if (figures.size() != spec.expectations.size())
    throw std::runtime_error("its figures are not those of its case");
  for (std::size_t k = 0; k < figures.size(); ++k)
    variant.expectations.push_back(
        {spec.expectations[k], figures[k].at("unit").get<std::string>(), number(figures[k].at("found"))});
  return variant;
}

VariantsStudy study_of(const Json& json) {
  if (json.at("kind").get<std::string>() != "variants")
    throw std::runtime_error("it is no study of variants");
  if (const int version = json.at("version").get<int>(); version < 1 || version > variants_file_version)
    throw std::runtime_error(
        fmt::format("its version is {}, this program reads up to {}", version, variants_file_version));
  VariantsStudy study{load_case(case_source_from_json(json.at("case"))), {}};
  study.result.title = study.loaded.spec.title;
  const std::vector<VariantSpec>& specs = study.loaded.spec.variants;
  const Json& variants = json.at("variants");
  if (variants.size() != specs.size()) throw std::runtime_error("its variants are not those of its case");
  for (std::size_t k = 0; k < specs.size(); ++k)
    study.result.variants.push_back(variant_of(variants[k], specs[k], study.loaded.source));
  for (const auto& [name, value] : json.at("provenance").items())
    study.result.provenance.emplace_back(name, value.get<std::string>());
  return study;
}

}  // namespace

std::string encode_variants(const VariantsStudy& study) {
  Json json{{"kind", "variants"}, {"version", variants_file_version}};
  json["case"] = case_source_to_json(study.loaded.source);
  json["variants"] = Json::array();
  for (const VariantResult& variant : study.result.variants)
    json["variants"].push_back(variant_json(variant));
  json["provenance"] = Json::object();
  for (const auto& [name, value] : study.result.provenance) json["provenance"][name] = value;
  return to_summed_text(std::move(json), -1);
}

VariantsStudy decode_variants(const std::string& text) {
  try {
    return study_of(parse_json<Json>(text, "study.json"));
  } catch (...) {
    refuse_unusable("study.json");
  }
}

}  // namespace plumb
