#include "report/page/page_tables.h"

#include <fmt/format.h>

#include "report/base/document_value.h"
#include "report/page/page_template.h"

namespace plumb {
namespace {

using kainjow::mustache::data;
using Pairs = std::vector<std::pair<std::string, std::string>>;

std::string exact(const Document& value) {
  return value.is_number() ? fmt::format("{:.12g}", value.get<double>()) : "not finite";
}

std::string vector_text(const Document& v) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.at(0).get<double>(), v.at(1).get<double>(),
                     v.at(2).get<double>());
}

const Document* reference_named(const Document& document, const std::string& name) {
  for (const Document& reference : document.at("references"))
    if (reference.at("name") == name) return &reference;
  return nullptr;
}

std::string eigenvalues(long negative) {
  return negative < 0 ? "cannot be counted" : std::to_string(negative);
}

/// What statics knows of its equilibria.
void add_equilibria(const Document& equilibria, Pairs& rows) {
  const Document& negative = equilibria.at("negative_eigenvalues");
  long unstable = 0;
  for (const Document& one : negative) unstable += one.get<long>() != 0 ? 1 : 0;
  rows.emplace_back("negative eigenvalues of the stiffness, at the last output",
                    negative.empty() ? "no output" : eigenvalues(negative.back().get<long>()));
  rows.emplace_back("outputs that the cable would leave", fmt::format("{} of {}", unstable, negative.size()));
  for (const Document& point : equilibria.at("critical_points"))
    rows.emplace_back(
        point.at("kind") == "limit-point" ? "limit point" : "bifurcation",
        fmt::format("at {:.7g} of the load, {} m displaced; negative eigenvalues {} before and {} after; its "
                    "mode moves most at {} of the length, along {}; {}",
                    point.at("load").get<double>(), four_digits(point.at("displacement")),
                    eigenvalues(point.at("negative_before").get<long>()),
                    eigenvalues(point.at("negative_after").get<long>()), four_digits(point.at("at")),
                    vector_text(point.at("direction")), text_of(point, "what_followed")));
}

}  // namespace

data error_rows(const Document& document) {
  data rows{data::type::list};
  for (const Document& error : document.at("errors")) {
    const Document* reference = reference_named(document, text_of(error, "reference"));
    const std::string unit = text_of(error, "unit");
    const bool any = error.at("points").get<long>() > 0, length = any && unit == "m";
    data row;
    row["run"] = error.value("run", "Plumb");
    row["reference"] = text_of(error, "reference");
    row["column"] = text_of(error, "column");
    row["series"] = text_of(error, "description");
    row["figure"] = text_of(error, "figure");
    row["published"] = reference != nullptr && reference->at("kind") == "published";
    row["unit"] = unit;
    const Document& coverage = error.at("coverage");
    row["points"] =
        fmt::format("{} of {}", error.at("points").get<long>(), coverage.at("demanded").get<long>());
    row["range"] =
        any ? fmt::format("{} to {}", four_digits(coverage.at("first")), four_digits(coverage.at("last")))
            : "–";
    row["gap"] = any ? four_digits(coverage.at("longest_gap")) : "–";
    row["max"] = any ? four_digits(error.at("max")) : "not run";
    row["max_time"] = any ? four_digits(error.at("max_time")) : "–";
    row["rms"] = any ? four_digits(error.at("rms")) : "not run";
    row["max_relative"] = length ? four_digits(error.at("max_relative_to_length")) : "–";
    row["rms_relative"] = length ? four_digits(error.at("rms_relative_to_length")) : "–";
    row["uncertainty"] = four_digits(error.at("reference_uncertainty"));
    row["basis"] = text_of(error, "reference_uncertainty_basis");
    rows.push_back(row);
  }
  return rows;
}

data reference_rows(const Document& document) {
  data rows{data::type::list};
  for (const Document& reference : document.at("references")) {
    const bool published = reference.at("kind") == "published";
    data row;
    row["name"] = text_of(reference, "name");
    row["title"] = text_of(reference, "title");
    row["published"] = published;
    row["kind"] = published ? "published, so it can validate" : "computed, so it can verify but not validate";
    row["source"] = text_of(reference, "source");
    row["obtained"] = text_of(reference, "obtained");
    row["reason"] = text_of(reference, "reason");
    row["has_reason"] = !text_of(reference, "reason").empty();
    data notes{data::type::list};
    for (const Document& note : reference.at("notes")) notes.push_back(data{"note", note.get<std::string>()});
    row.set("notes", notes);
    rows.push_back(row);
  }
  return rows;
}

data cost_rows(const Document& document) {
  const Document& solve = document.at("solve");
  const auto count = [&](const char* key) {
    const long n = solve.at(key).get<long>();
    return n < 0 ? std::string("not counted") : std::to_string(n);
  };
  Pairs rows;
  rows.emplace_back("outcome", text_of(document, "outcome") + ": " + text_of(document, "outcome_reason"));
  if (document.contains("computed_by")) {
    rows.emplace_back("computed by", text_of(document, "computed_by"));
    rows.emplace_back("outputs", count("outputs"));
    rows.emplace_back("last output", four_digits(solve.at("end_time")) + " s");
    rows.emplace_back("energy, steps, evaluations and time",
                      "not known: computed by " + text_of(document, "reported"));
    return pair_rows(rows);
  }
  rows.emplace_back("method", text_of(solve, "method"));
  rows.emplace_back("elements", count("elements"));
  rows.emplace_back("time reached", four_digits(solve.at("end_time")) + " s");
  rows.emplace_back("steps (rejected)", count("steps") + " (" + count("rejected_steps") + ")");
  if (const std::string cuts =
          step_cuts(solve.at("rejected_steps").get<long>(), solve.at("shortest_cut").get<double>());
      !cuts.empty())
    rows.emplace_back("its step", cuts);
  rows.emplace_back("force evaluations", count("force_evaluations"));
  rows.emplace_back("tangent evaluations", count("tangent_evaluations"));
  rows.emplace_back("factorizations of the block banded matrix", count("factorizations"));
  rows.emplace_back("Newton iterations", count("newton_iterations"));
  const Document& seconds = solve.at("solve_seconds");
  rows.emplace_back("time loop", seconds.get<double>() < 0 ? "not run" : four_digits(seconds) + " s");
  rows.emplace_back("outputs (interpolated)",
                    fmt::format("{} ({})", count("outputs"), count("interpolated_outputs")));
  if (solve.at("constraint_drift").get<double>() >= 0) {
    rows.emplace_back("greatest drift of the joint", four_digits(solve.at("constraint_drift")) + " m");
    rows.emplace_back("greatest reaction at the joint", four_digits(solve.at("greatest_reaction")) + " N");
  }
  if (solve.contains("equilibria")) add_equilibria(solve.at("equilibria"), rows);
  return pair_rows(rows);
}

data case_rows(const Document& document) {
  const Document& the_case = document.at("case");
  const Document &cable = the_case.at("cable"), &start = the_case.at("start"), &loads = the_case.at("loads");
  const auto value = [&](const char* key) { return cable.at(key).get<double>(); };
  const auto product = [](double a, double b) { return fmt::format("{:.12g}", a * b); };
  Pairs rows;
  for (const auto& [name, parameter] : the_case.at("parameters").items())
    rows.emplace_back("parameter " + name, exact(parameter));
  rows.emplace_back("length L", exact(cable.at("length")) + " m");
  rows.emplace_back("axial stiffness EA", product(value("youngs_modulus"), value("area")) + " N");
  rows.emplace_back("bending stiffness EI",
                    product(value("youngs_modulus"), value("second_moment")) + " N m²");
  rows.emplace_back("mass per length ρA", product(value("density"), value("area")) + " kg/m");
  // How another program models the cable is not for Plumb to say.
  const bool solved_here = the_case.contains("method");
  if (solved_here) {
    rows.emplace_back("model", text_of(cable, "model"));
    rows.emplace_back("strain model", text_of(cable, "strain"));
    if (text_of(cable, "model") == word(CableModel::cable))
      rows.emplace_back("quadrature", text_of(cable, "quadrature"));
  }
  rows.emplace_back("direction at the start", vector_text(start.at("direction")));
  rows.emplace_back("angular velocity at the start", vector_text(start.at("angular_velocity")) + " rad/s");
  if (solved_here) rows.emplace_back("slope rates at the start", text_of(start, "slope_rates"));
  rows.emplace_back("axial speed of the last end at the start", exact(start.at("axial_speed")) + " m/s");
  if (start.value("imperfection", 0.0) != 0)
    rows.emplace_back("imperfection of the start, in the first buckling mode",
                      exact(start.at("imperfection")) + " m");
  rows.emplace_back("supports", text_of(the_case.at("supports"), "first") + " – " +
                                    text_of(the_case.at("supports"), "last"));
  for (const LoadKey& key : load_keys)
    rows.emplace_back(key.meaning,
                      fmt::format("{} {}", vector_text(loads.at(std::string(key.name))), key.unit));
  if (!solved_here) return pair_rows(rows);
  std::string method;
  for (const auto& [name, setting] : the_case.at("method").items())
    method += name == "name" ? setting.get<std::string>()
              : setting.is_string()
                  ? fmt::format(", {} {}", name, setting.get<std::string>())
                  : fmt::format(", {} {:.6g}{}", name, setting.get<double>(), name == "step" ? " s" : "");
  rows.emplace_back("method", method);
  return pair_rows(rows);
}

}  // namespace plumb
