#include "report/page/page_tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "engine/read/model_keys.h"
#include "engine/run/mode_table.h"
#include "report/base/document_value.h"
#include "report/figure/number_markup.h"
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

/// A value of a key of the case; of a table "axis (0, 0, 1), angle 6*t".
std::string in_words(const Document& value) {
  if (value.is_object()) {
    std::vector<std::string> parts;
    for (const auto& [name, part] : value.items()) parts.push_back(name + " " + in_words(part));
    return fmt::format("{}", fmt::join(parts, ", "));
  }
  return value.is_array() ? vector_text(value) : value.is_string() ? value.get<std::string>() : exact(value);
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
    row["reference"] =
        text_of(error, "reference") + (error.value("against", "printed") == "exact" ? ": exact" : "");
    row["column"] = text_of(error, "column");
    row["series"] = text_of(error, "description");
    row["figure"] = text_of(error, "figure");
    row["published"] = reference != nullptr && reference->at("kind") == "published" &&
                       error.value("against", "printed") != "exact";
    row["unit"] = unit_text(unit);
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

namespace {

data text_rows_of(const Document& texts, const std::string& key) {
  data rows{data::type::list};
  for (const Document& text : texts) rows.push_back(data{key, text.get<std::string>()});
  return rows;
}

}  // namespace

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
    row["exact"] = reference.value("exact", "");
    row["has_exact"] = reference.contains("exact");
    row.set("differences",
            text_rows_of(reference.value("model_differences", Document::array()), "difference"));
    row["has_model"] = reference.contains("model_differences");
    row["has_reason"] = !text_of(reference, "reason").empty();
    row.set("notes", text_rows_of(reference.at("notes"), "note"));
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
  if (const std::string remark = text_of(solve, "remark"); !remark.empty())
    rows.emplace_back("remark", remark);
  rows.emplace_back("method", text_of(solve, "method"));
  rows.emplace_back("elements", count("elements"));
  const bool modal = document.contains(modes_key);
  if (!modal) rows.emplace_back("time reached", four_digits(solve.at("end_time")) + " s");
  if (!modal) rows.emplace_back("steps (rejected)", count("steps") + " (" + count("rejected_steps") + ")");
  if (const std::string cuts =
          step_cuts(solve.at("rejected_steps").get<long>(), solve.at("shortest_cut").get<double>());
      !cuts.empty())
    rows.emplace_back("its step", cuts);
  rows.emplace_back("force evaluations", count("force_evaluations"));
  rows.emplace_back("tangent evaluations", count("tangent_evaluations"));
  rows.emplace_back("factorizations of the block banded matrix", count("factorizations"));
  rows.emplace_back("Newton iterations", count("newton_iterations"));
  const Document& seconds = solve.at("solve_seconds");
  rows.emplace_back(modal ? "time of solving" : "time loop",
                    seconds.get<double>() < 0 ? "not run" : four_digits(seconds) + " s");
  if (!modal)
    rows.emplace_back("outputs (interpolated)",
                      fmt::format("{} ({})", count("outputs"), count("interpolated_outputs")));
  if (solve.at("constraint_drift").get<double>() >= 0) {
    rows.emplace_back("greatest drift of the joint", four_digits(solve.at("constraint_drift")) + " m");
    rows.emplace_back("greatest reaction at the joint", four_digits(solve.at("greatest_reaction")) + " N");
  }
  if (solve.contains("equilibria")) add_equilibria(solve.at("equilibria"), rows);
  return pair_rows(rows);
}

/// A row each; reports of older versions have none.
void add_loads_and_masses(const Document& the_case, Pairs& rows) {
  const auto each = [&](const char* table, auto in_a_row) {
    if (!the_case.contains(table)) return;
    int number = 0;
    for (const Document& item : the_case.at(table))
      rows.emplace_back(fmt::format("{} {}", table, ++number), in_a_row(item));
  };
  each("load", [](const Document& load) {
    const std::string kind = text_of(load, "kind");
    const bool everywhere = kind == word(LoadKind::distributed);
    const char* unit = everywhere ? "N/m" : kind == word(LoadKind::moment) ? "N m" : "N";
    std::string text = fmt::format("{} {}{}", kind, in_words(load.at("value")), unit_after(unit));
    if (!everywhere) text += " at " + in_words(load.at("at")) + " of the length";
    if (load.at("follows").get<bool>()) text += ", turning with the cable";
    if (const std::string factor = text_of(load, "factor"); factor != "1") text += ", times " + factor;
    return text;
  });
  each("mass", [](const Document& mass) {
    return in_words(mass.at("mass")) + " kg at " + in_words(mass.at("at")) + " of the length";
  });
}

data case_rows(const Document& document) {
  const Document &the_case = document.at("case"), &cable = the_case.at("cable");
  // How another program models the cable is not for Plumb to say.
  const bool solved_here = the_case.contains("method");
  std::vector<std::string_view> foreign;
  for (const auto& model : words_of<CableModel>)
    if (model.word == text_of(cable, "model")) foreign = foreign_keys(model.value);
  Pairs rows;
  for (const auto& [name, parameter] : the_case.at("parameters").items())
    rows.emplace_back("parameter " + name, exact(parameter));
  const auto add = [&](const char* table, const auto& spec) {
    // Reports of older versions do not have all of them.
    if (!the_case.contains(table)) return;
    visit_keys(spec, [&](const Key& key, const auto&) {
      const Document &values = the_case.at(table), none;
      const Document& value = values.contains(key.name) ? values.at(std::string(key.name)) : none;
      if (value.is_null() || (key.of_computation && !solved_here) ||
          std::find(foreign.begin(), foreign.end(), key.name) != foreign.end())
        return;
      rows.emplace_back(key.meaning, in_words(value) + unit_after(key.range.unit));
    });
  };
  const Case any;
  visit_motion(any, add);
  add_loads_and_masses(the_case, rows);
  if (!document.contains(modes_key)) add("time", any.time);
  const auto product = [&](const char* meaning, const char* a, const char* b, const char* unit) {
    rows.emplace_back(meaning, fmt::format("{:.12g}{}", cable.at(a).get<double>() * cable.at(b).get<double>(),
                                           unit_after(unit)));
  };
  product("axial stiffness EA", "youngs_modulus", "area", "N");
  product("bending stiffness EI", "youngs_modulus", "second_moment", "N m²");
  product("mass per length ρA", "density", "area", "kg/m");
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
