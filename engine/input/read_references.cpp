#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "engine/input/case_sections.h"
#include "engine/input/name_rule.h"
#include "engine/input/nearest.h"
#include "engine/input/probe_columns.h"

namespace plumb {
namespace {

/// `compare = { mid_y = "mid.y" }`, not yet held against the reference itself.
std::vector<Comparison> read_comparisons(TableReader table, const std::vector<ProbeSpec>& probes) {
  std::vector<Comparison> comparisons;
  for (const TomlValue& item : table.value().items) {
    const Comparison comparison{item.key, table.text_in(item, table.full_key(item.key))};
    const std::vector<std::string> columns = all_columns(probes);
    if (std::find(columns.begin(), columns.end(), comparison.column) == columns.end()) {
      table.refuse_value(item.key, "not a column of the probes" + suggestion(comparison.column, columns));
    }
    for (const Comparison& other : comparisons) {
      if (other.column != comparison.column) continue;
      table.refuse_value(item.key, fmt::format("the column is compared with {} already", other.series));
    }
    comparisons.push_back(comparison);
  }
  return comparisons;
}

void check_series(const TableReader& compare, const ReferenceUse& use, const Reference& reference,
                  const std::vector<ProbeSpec>& probes) {
  std::vector<std::string> names;
  for (const ReferenceSeries& series : reference.series) names.push_back(series.name);
  for (const Comparison& comparison : use.compare) {
    const ReferenceSeries* series = reference.find(comparison.series);
    if (series == nullptr) {
      const TomlValue& item = *compare.value().find(comparison.series);
      refuse(item.key_place, compare.full_key(item.key), item.written,
             fmt::format("{} has no series \"{}\"{}", use.file, item.key, suggestion(item.key, names)));
    }
    const std::string_view probed = unit(probe_of(comparison.column, probes)->quantity);
    if (series->unit != probed) {
      compare.refuse_value(comparison.series,
                           fmt::format("the unit must be that of the series, {}; that of the column is {}",
                                       series->unit, probed));
    }
  }
}

std::string default_name(const std::string& file) {
  return std::filesystem::path(file).stem().string();
}

void check_name(const TableReader& table, const std::string& name, bool given,
                const std::vector<ReferenceUse>& others) {
  const std::string end =
      given ? "" : fmt::format(" (it is \"{}\", from the file's name, unless given)", name);
  if (!follows_name_rule(name)) table.refuse_value("name", fmt::format("must be {}{}", name_rule, end));
  const auto same = [&](const ReferenceUse& other) { return other.name == name; };
  if (std::any_of(others.begin(), others.end(), same)) {
    table.refuse_value("name", fmt::format("must differ from that of every other reference{}", end));
  }
}

}  // namespace

ReferencesRead read_references(std::vector<TableReader> tables, const std::string& case_name,
                               const ReferenceText& text_of, const std::vector<ProbeSpec>& probes,
                               const TimeSpec& time) {
  ReferencesRead read;
  for (TableReader& table : tables) {
    ReferenceUse use;
    use.file = table.text("file", "the path of a reference file, relative to this one");
    const bool name_given = table.has("name");
    use.name = name_given ? table.text("name", "a name") : default_name(use.file);
    TableReader compare =
        table.required_table("compare", "series and their columns, as in compare = { mid_y = \"mid.y\" }");
    use.norm = table.choice<Norm>("norm", Norm::max);
    use.tolerance = table.number("tolerance", Range::positive("the unit of the series"));
    use.reason = table.optional_prose("reason");
    const TableReader coverage = table.table("coverage");
    table.finish();

    check_name(table, use.name, name_given, read.uses);
    use.compare = read_comparisons(compare, probes);
    if (use.compare.empty()) table.refuse_value("compare", "must name at least one series and its column");

    const FileText file = text_of(use.file);
    if (!file.failure.empty()) table.refuse_value("file", "cannot be read: " + file.failure);
    const std::string shown_name = (std::filesystem::path(case_name).parent_path() / use.file).string();
    Reference reference = read_reference({shown_name, file.text});
    check_series(compare, use, reference, probes);

    use.coverage = read_coverage(coverage, reference.times, use.file);

    constexpr double rounding = 1e-9;
    const auto beyond = std::count_if(reference.times.begin(), reference.times.end(), [&](double t) {
      return t > time.end * (1 + rounding) && use.coverage.has(t);
    });
    if (beyond > 0)
      read.remarks.push_back(fmt::format(
          "{} of the {} times of {} are beyond the end of the run, {} s: a criterion is not run unless its "
          "coverage says that it claims less",
          beyond, reference.times.size(), use.file, time.end));
    const auto same_file = [&](const NamedText& text) { return text.name == use.file; };
    if (std::none_of(read.texts.begin(), read.texts.end(), same_file))
      read.texts.push_back({use.file, file.text});
    read.uses.push_back(std::move(use));
    read.references.push_back(std::move(reference));
  }
  return read;
}

}  // namespace plumb
