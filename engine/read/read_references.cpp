#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <unordered_map>

#include "engine/base/nearest.h"
#include "engine/case/column_quantity.h"
#include "engine/case/name_rule.h"
#include "engine/case/probe_columns.h"
#include "engine/read/case_sections.h"

namespace plumb {
namespace {

/// `compare = { mid_y = "mid.y" }`, not yet held against the reference itself.
std::vector<Comparison> read_comparisons(TableReader table, const ProbeColumns& columns, Abscissa own) {
  std::vector<Comparison> comparisons;
  std::unordered_map<std::string, std::string> series_of;
  for (const TomlValue& item : table.value().items) {
    const Comparison comparison{item.key, table.text_in(item, table.full_key(item.key))};
    const ColumnQuantity quantity = column_quantity(comparison.column);
    if (!columns.unit(quantity.column))
      table.refuse_value(item.key,
                         "not a column of the probes" + suggestion(quantity.column, columns.names()));
    if (quantity.is_aggregate() && own != Abscissa::time)
      table.refuse_value(
          item.key, fmt::format("is read off a motion over time; a run with this method has {}s", word(own)));
    if (const auto [other, is_new] = series_of.emplace(comparison.column, comparison.series); !is_new)
      table.refuse_value(item.key, fmt::format("the column is compared with {} already", other->second));
    comparisons.push_back(comparison);
  }
  return comparisons;
}

void check_series(const TableReader& compare, const ReferenceUse& use, const Reference& reference,
                  const ProbeColumns& columns) {
  std::vector<std::string> names;
  for (const ReferenceSeries& series : reference.series) names.push_back(series.name);
  for (const Comparison& comparison : use.compare) {
    const ReferenceSeries* series = reference.find(comparison.series);
    if (series == nullptr) {
      const TomlValue& item = *compare.value().find(comparison.series);
      refuse(item.key_place, compare.full_key(item.key), item.written,
             fmt::format("{} has no series \"{}\"{}", use.file, item.key, suggestion(item.key, names)));
    }
    const std::string_view probed = unit(column_quantity(comparison.column), columns).value();
    if (series->unit != probed) {
      compare.refuse_value(comparison.series,
                           fmt::format("the unit must be that of the series, {}; that of the column is {}",
                                       series->unit, probed));
    }
  }
}

/// Refuses a reference over what a run does not have: one of modes has neither time nor load, and one over a
/// time has a load that grows with it where it is one of statics alone, whose own abscissa is `load`.
void check_abscissa(const TableReader& table, Abscissa of_reference, Abscissa own) {
  if (of_reference == own || (of_reference == Abscissa::time && own == Abscissa::load)) return;
  constexpr const char* which = "its first column is \"{}\"; a run with this method has {}";
  table.refuse_value("file", fmt::format(which, word(of_reference),
                                         own == Abscissa::mode   ? "modes, \"mode\", alone"
                                         : own == Abscissa::load ? "times, \"t\", and loads, \"load\""
                                                                 : "times, \"t\", alone"));
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

const FileText& ReferenceFiles::text(const std::string& file) {
  File& found = files_[file];
  if (!found.text) found.text = text_of_(file, InputKind::reference);
  return *found.text;
}

const Reference& ReferenceFiles::reference(const std::string& file, const std::string& shown_name) {
  File& found = files_[file];
  if (!found.reference) found.reference = read_reference({shown_name, text(file).text});
  return *found.reference;
}

ReferencesRead read_references(std::vector<TableReader> tables, const std::string& case_name,
                               ReferenceFiles& files, const std::vector<ProbeSpec>& probes,
                               const TimeSpec& time, Abscissa own) {
  ReferencesRead read;
  const ProbeColumns columns(probes, own == Abscissa::mode);
  if (tables.size() > most_files)
    tables[most_files].refuse_value(
        "file",
        fmt::format("at most {} tables [[reference]] are allowed, found {}", most_files, tables.size()));
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
    const bool has_whole_load = table.has("whole_load");
    use.whole_load = table.number("whole_load", Range::positive("the unit of the reference's load"), 1);
    table.finish();

    check_name(table, use.name, name_given, read.uses);
    use.compare = read_comparisons(compare, columns, own);
    if (use.compare.empty()) table.refuse_value("compare", "must name at least one series and its column");

    const FileText& file = files.text(use.file);
    if (!file.failure.empty()) table.refuse_value("file", "cannot be read: " + file.failure);
    const std::string shown_name = (std::filesystem::path(case_name).parent_path() / use.file).string();
    Reference reference = files.reference(use.file, shown_name);
    check_abscissa(table, reference.abscissa, own);
    if (has_whole_load && reference.abscissa != Abscissa::load)
      table.refuse_value("whole_load", "is asked for where the first column of the reference is \"load\"");
    check_series(compare, use, reference, columns);
    if (reference.abscissa == Abscissa::load)
      for (double& at : reference.times) at *= time.end / use.whole_load;

    use.coverage = read_coverage(coverage, reference.times, use.file);

    constexpr double rounding = 1e-9;
    const auto beyond = std::count_if(reference.times.begin(), reference.times.end(), [&](double t) {
      return t > time.end * (1 + rounding) && use.coverage.has(t);
    });
    if (beyond > 0 && own != Abscissa::mode)
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
