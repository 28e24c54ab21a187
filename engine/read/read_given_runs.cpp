#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <unordered_set>

#include "engine/base/errors.h"
#include "engine/base/nearest.h"
#include "engine/base/number_text.h"
#include "engine/base/units.h"
#include "engine/case/column_quantity.h"
#include "engine/case/name_rule.h"
#include "engine/case/probe_columns.h"
#include "engine/read/case_sections.h"
#include "engine/read/given_table.h"

namespace plumb {
namespace {

constexpr const char* time_column = "t";
constexpr const char* file_of_point = "the path of a CSV or HDF5 file, relative to this one";

std::string base_unit(const std::string& column, const ProbeColumns& columns) {
  return column == time_column ? "s" : std::string(columns.unit(column).value());
}

/// Refuses the item where its key is no column of the probes.
void check_key(const TableReader& table, const TomlValue& item, const ProbeColumns& columns, bool or_time) {
  if (columns.unit(item.key) || (or_time && item.key == time_column)) return;
  std::vector<std::string> known = columns.names();
  if (or_time) known.emplace_back(time_column);
  refuse(item.key_place, table.full_key(item.key), item.written,
         "not a column of the probes" + suggestion(item.key, known));
}

std::map<std::string, std::string> read_texts(const TableReader& table, const ProbeColumns& columns) {
  std::map<std::string, std::string> result;
  for (const TomlValue& item : table.value().items) {
    check_key(table, item, columns, true);
    result[item.key] = table.text_in(item, table.full_key(item.key));
  }
  return result;
}

std::map<std::string, double> read_tolerances(const TableReader& table, const ProbeColumns& columns) {
  std::map<std::string, double> result;
  for (const TomlValue& item : table.value().items) {
    check_key(table, item, columns, false);
    result[item.key] =
        table.number_in(item, table.full_key(item.key), Range::positive(base_unit(item.key, columns)));
  }
  return result;
}

void check_name(const TableReader& table, const std::string& name, bool given,
                const std::vector<GivenRunSpec>& others) {
  const std::string end =
      given ? "" : fmt::format(" (it is \"{}\", from the file's name, unless given)", name);
  if (!follows_name_rule(name)) table.refuse_value("name", fmt::format("must be {}{}", name_rule, end));
  if (name == "Plumb") table.refuse_value("name", "is the name of Plumb's own run" + end);
  const auto same = [&](const GivenRunSpec& other) { return other.name == name; };
  if (std::any_of(others.begin(), others.end(), same))
    table.refuse_value("name", "must differ from that of every other run" + end);
}

/// How fast the program was, and where.
void read_speed(TableReader& table, GivenRunSpec& spec) {
  constexpr int most_threads = 1 << 24;
  const Range positive = Range::positive("s");
  spec.seconds = table.optional_number("seconds", positive).value_or(spec.seconds);
  spec.threads = table.whole("threads", 1, most_threads, spec.threads);
  if (table.has("machine")) spec.machine = table.text("machine", "the name of the machine that it ran on");
  spec.yardstick = table.optional_number("yardstick", positive).value_or(spec.yardstick);
  if (spec.seconds > 0 || table.has("point")) return;
  for (const char* key : {"threads", "machine", "yardstick"})
    if (table.has(key))
      table.refuse_value(key, "belongs to seconds or [[run.point]], of which the run has none");
}

GivenPointSpec read_point(TableReader& table, const GivenRunSpec& run, const ProbeColumns& keys) {
  GivenPointSpec point;
  point.file = table.text("file", file_of_point);
  point.seconds = table.number("seconds", Range::positive("s"));
  point.label = table.has("label") ? table.text("label", "what tells the point from others")
                                   : std::filesystem::path(point.file).stem().string();
  const TableReader columns = table.table("columns"), units = table.table("units");
  table.finish();
  point.columns = read_texts(columns, keys);
  point.units = read_texts(units, keys);
  point.columns.insert(run.columns.begin(), run.columns.end());
  point.units.insert(run.units.begin(), run.units.end());
  for (const GivenPointSpec& other : run.points)
    if (other.label == point.label)
      table.refuse_value("label",
                         fmt::format("must differ from that of every other point of the run{}",
                                     table.has("label") ? ""
                                                        : fmt::format(" (it is \"{}\", from the file's name, "
                                                                      "unless given)",
                                                                      point.label)));
  return point;
}

/// Whether a column is two names that were not taken apart: "t tip.x".
bool is_of_two_names(std::string_view column, const std::vector<std::string>& names) {
  int found = 0;
  while (!column.empty()) {
    const std::size_t end = std::min(column.find_first_of(" \t;|,"), column.size());
    const std::string_view word = column.substr(0, end);
    found += word == "Time" || word == "time" || word == time_column ||
                     std::find(names.begin(), names.end(), word) != names.end()
                 ? 1
                 : 0;
    column.remove_prefix(std::min(end + 1, column.size()));
  }
  return found > 1;
}

/// "; did you mean "mid y"? The file has: t, mid y, tip y".
std::string what_is_there(const std::string& name, const GivenTable& file, const ProbeColumns& probes) {
  constexpr std::size_t most = 20;
  std::vector<std::string> names;
  for (const GivenTable::Column& column : file.columns()) names.push_back(column.name);
  // What has one column is hardly a table: a file that was named by mistake is not shown.
  if (names.size() == 1) return "; the file has one column only";
  const std::string_view nearest_name = nearest(name, names);
  const std::string near = is_of_two_names(nearest_name, probes.names()) ? "" : short_value(nearest_name);
  const std::size_t more = names.size() > most ? names.size() - most : 0;
  names.resize(names.size() - more);
  for (std::string& shown : names) shown = short_value(shown);
  return (near.empty() ? "; the" : fmt::format("; did you mean \"{}\"? The", near)) +
         fmt::format(" file has: {}{}", fmt::join(names, ", "),
                     more > 0 ? fmt::format(" and {} more", more) : "");
}

/// Reads the columns that one [[run]] asks for from its file.
class RunReader {
 public:
  RunReader(const TableReader& table, const TableReader& columns, const TableReader& units,
            const GivenRunSpec& spec, const GivenTable& file, const ProbeColumns& probes)
      : table_(table), columns_(columns), units_(units), spec_(spec), file_(file), probes_(probes) {}

  GivenRun read() {
    GivenRun run;
    run.notes = file_.notes();
    run.taken_for = file_.taken_for();
    run.ending = file_.ending();
    run.own_case = file_.own_case();
    read_times(run);
    for (const std::string& name : probes_.names()) {
      const int found = find(name);
      if (found < 0) continue;
      GivenColumn column;
      column.name = name;
      column.file_column = file_.columns()[static_cast<std::size_t>(found)].name;
      column.unit = base_unit(name, probes_);
      column.file_unit = unit_of(name, found, run);
      column.values = converted(found, column.file_unit, column.unit);
      if (column.values.size() != rows_)
        throw InputError(fmt::format("{}: the column has {} rows, that of the time {}",
                                     file_.columns()[static_cast<std::size_t>(found)].place,
                                     column.values.size(), rows_));
      column.values = of_kept_rows(column.values);
      run.columns.push_back(std::move(column));
    }
    if (run.columns.empty()) {
      const std::vector<std::string>& wanted = probes_.names();
      table_.refuse_value(
          "columns", wanted.empty()
                         ? "the case has no [[probe]] that a column of the file could be of"
                         : fmt::format("{} has no column of the probes, as {}{}", spec_.file, wanted.front(),
                                       what_is_there(wanted.front(), file_, probes_)));
    }
    return run;
  }

 private:
  /// The place of the column that the file has for `name`; -1: none.
  int find(const std::string& name) const {
    const auto mapped = spec_.columns.find(name);
    if (mapped == spec_.columns.end()) {
      for (const std::string& usual : file_.usual_names(name))
        if (const int found = file_.find(usual); found >= 0) return found;
      return -1;
    }
    if (mapped->second.empty()) return -1;
    const int found = file_.find(mapped->second);
    if (found < 0)
      columns_.refuse_value(name, fmt::format("{} has no such column{}", spec_.file,
                                              what_is_there(mapped->second, file_, probes_)));
    return found;
  }

  /// Where a run that was stopped goes on from an earlier time, what it had from there on is left out.
  void leave_out_what_is_repeated(GivenRun& run) {
    const std::vector<std::size_t>& restarts = file_.restarts();
    std::size_t left_out = 0;
    for (std::size_t row = 0; row < run.times.size(); ++row) {
      if (std::find(restarts.begin(), restarts.end(), row) != restarts.end())
        for (; !kept_.empty() && run.times[kept_.back()] >= run.times[row]; ++left_out) kept_.pop_back();
      kept_.push_back(row);
    }
    if (left_out > 0)
      run.notes.push_back(fmt::format("{} before a repeated header left out, as {} times come again after it",
                                      left_out == 1 ? "a row" : fmt::format("{} rows", left_out),
                                      left_out == 1 ? "its" : "their"));
    run.times = of_kept_rows(run.times);
  }

  std::vector<double> of_kept_rows(const std::vector<double>& values) const {
    std::vector<double> kept;
    kept.reserve(kept_.size());
    for (const std::size_t row : kept_) kept.push_back(values[row]);
    return kept;
  }

  void read_times(GivenRun& run) {
    const int found = find(time_column);
    if (found < 0)
      table_.refuse_value("columns",
                          fmt::format("{} has no column \"t\" for the time{}; name it, as in columns = {{ "
                                      "t = \"Time\" }}",
                                      spec_.file, what_is_there("time", file_, probes_)));
    run.time_column = file_.columns()[static_cast<std::size_t>(found)].name;
    run.time_unit = unit_of(time_column, found, run);
    run.times = converted(found, run.time_unit, "s");
    rows_ = run.times.size();
    leave_out_what_is_repeated(run);
    for (std::size_t row = 1; row < run.times.size(); ++row)
      if (!(run.times[row] > run.times[row - 1]))
        throw InputError(fmt::format("{}: {} = {} s: must be greater than the time before it, {} s",
                                     file_.place(found, kept_[row]), run.time_column,
                                     number_text(run.times[row]), number_text(run.times[row - 1])));
  }

  std::string unit_of(const std::string& name, int column, GivenRun& run) const {
    const GivenTable::Column& found = file_.columns()[static_cast<std::size_t>(column)];
    const std::string base = base_unit(name, probes_);
    if (const auto given = spec_.units.find(name); given != spec_.units.end()) {
      if (!unit_factor(given->second, base)) units_.refuse_value(name, unit_fault(given->second, base));
      if (!found.unit.empty() && found.unit != given->second)
        run.notes.push_back(
            fmt::format("the column {} is read in {}, as the case says, though the file says {}", found.name,
                        given->second, found.unit));
      return given->second;
    }
    if (found.unit.empty()) return base;
    if (!unit_factor(found.unit, base))
      throw InputError(fmt::format("{}: {} [{}]: the unit {}; units of the [[run]] may name another",
                                   found.place, found.name, found.unit, unit_fault(found.unit, base)));
    return found.unit;
  }

  std::vector<double> converted(int column, const std::string& from, const std::string& base) const {
    std::vector<double> values = file_.values(column);
    const double factor = *unit_factor(from, base);
    for (std::size_t row = 0; row < values.size(); ++row) {
      values[row] *= factor;
      if (!std::isfinite(values[row]))
        throw InputError(fmt::format("{}: is not finite in {}", file_.place(column, row), base));
    }
    return values;
  }

  const TableReader &table_, &columns_, &units_;
  const GivenRunSpec& spec_;
  const GivenTable& file_;
  const ProbeColumns& probes_;
  std::size_t rows_ = 0;           ///< of the file
  std::vector<std::size_t> kept_;  ///< of these
};

/// A name after the file's, with _ for what a name may not have.
std::string name_of_file(const std::string& file) {
  std::string name = std::filesystem::path(file).stem().string();
  for (char& c : name)
    if (std::string one(1, c); !follows_name_rule("a" + one)) c = '_';
  return name;
}

/// The tables with one for each file where `file` is a folder or a pattern; of these, names are taken from
/// the files.
struct FilesOfRuns {
  std::vector<TableReader> tables;
  std::vector<std::string> files;
  std::vector<bool> is_one_of_many;
};

FilesOfRuns files_of_runs(std::vector<TableReader>& tables, const NamesOfFiles& names_of) {
  FilesOfRuns all;
  for (TableReader& table : tables) {
    std::vector<TableReader> points = table.tables("point");
    const std::string file =
        table.has("file") || points.empty()
            ? table.text("file",
                         "the path of a CSV or HDF5 file, of a folder of such, or a pattern, relative to "
                         "this one")
            : points.back().text("file", file_of_point);
    std::optional<std::vector<std::string>> names;
    if (!file.empty()) names = names_of(file);
    if (names && names->empty()) table.refuse_value("file", "there is no file in it");
    if (names && table.has("name"))
      table.refuse_value("name", "several files cannot have one name; each has that of its file");
    for (const char* key : {"seconds", "point"})
      if (names && table.has(key))
        table.refuse_value(key,
                           "is of one run, but file stands for several; give each a [[run]] or a "
                           "[[run.point]] of its own");
    for (const std::string& one : names.value_or(std::vector{file})) {
      if (all.files.size() == most_files)
        table.refuse_value("file", fmt::format("at most {} runs are allowed", most_files));
      all.tables.push_back(table);
      all.files.push_back(one);
      all.is_one_of_many.push_back(names.has_value());
    }
  }
  return all;
}

}  // namespace

GivenRunsRead read_given_runs(std::vector<TableReader>& tables, const std::string& case_name,
                              const ReferenceText& text_of, const NamesOfFiles& names_of,
                              const std::vector<ProbeSpec>& probes) {
  GivenRunsRead read;
  const ProbeColumns keys(probes);
  if (tables.size() > most_files)
    tables[most_files].refuse_value(
        "file", fmt::format("at most {} tables [[run]] are allowed, found {}", most_files, tables.size()));
  const FilesOfRuns of_tables = files_of_runs(tables, names_of);
  tables = of_tables.tables;
  const auto read_file = [&](const TableReader& table, const TableReader& columns, const TableReader& units,
                             const GivenRunSpec& spec) {
    FileText file = text_of(spec.file, InputKind::given_run);
    if (!file.failure.empty()) table.refuse_value("file", "cannot be read: " + file.failure);
    NamedText named{(std::filesystem::path(case_name).parent_path() / spec.file).string(),
                    std::move(file.text)};
    if (named.text.empty()) table.refuse_value("file", "is empty");
    GivenRun run = RunReader(table, columns, units, spec, *read_given_table(named), keys).read();
    const auto same_file = [&](const NamedText& text) { return text.name == spec.file; };
    if (std::any_of(read.texts.begin(), read.texts.end(), same_file)) return run;
    for (const std::string& note : run.notes) read.remarks.push_back(spec.file + ": " + note);
    read.texts.push_back({spec.file, std::move(named.text)});
    return run;
  };
  for (std::size_t k = 0; k < tables.size(); ++k) {
    TableReader& table = tables[k];
    GivenRunSpec spec;
    spec.file = of_tables.files[k];
    const bool name_given = table.has("name");
    spec.name = name_given                    ? table.text("name", "a name")
                : of_tables.is_one_of_many[k] ? name_of_file(spec.file)
                                              : std::filesystem::path(spec.file).stem().string();
    spec.program = table.optional_prose("program");
    const TableReader columns = table.table("columns"), units = table.table("units"),
                      tolerances = table.table("tolerances"), coverage = table.table("coverage");
    const bool has_coverage = table.has("coverage");
    spec.reason = table.optional_prose("reason");
    std::vector<TableReader> points = table.tables("point");
    read_speed(table, spec);
    table.finish();
    spec.columns = read_texts(columns, keys);
    spec.units = read_texts(units, keys);
    spec.tolerances = read_tolerances(tolerances, keys);
    if (has_coverage && spec.tolerances.empty())
      table.refuse_value("coverage", "belongs to tolerances, of which the run has none");

    std::vector<GivenRun> of_points;
    for (TableReader& point : points) {
      GivenPointSpec said = read_point(point, spec, keys);
      GivenRunSpec as_run = spec;
      as_run.file = said.file;
      as_run.columns = said.columns;
      as_run.units = said.units;
      of_points.push_back(read_file(point, point.table("columns"), point.table("units"), as_run));
      spec.points.push_back(std::move(said));
    }
    check_name(table, spec.name, name_given, read.specs);
    const bool is_last_point = !points.empty() && !table.has("file");
    if (is_last_point) {
      spec.columns = spec.points.back().columns;
      spec.units = spec.points.back().units;
    }
    GivenRun run = is_last_point ? of_points.back() : read_file(table, columns, units, spec);
    run.points = std::move(of_points);
    spec.coverage = read_coverage(coverage, run.times, spec.file);
    read.specs.push_back(std::move(spec));
    read.runs.push_back(std::move(run));
  }
  return read;
}

namespace {

/// Refuses a run with a time, and a point, without the position of the last end, which its error is of.
void check_tip(TableReader table, const Case& spec, const GivenRunSpec& given, const GivenRun& run) {
  const ProbeSpec* tip = tip_probe(spec);
  if (tip == nullptr)
    table.refuse_value(given.seconds > 0 ? "seconds" : "point",
                       "is shown beside the error of the tip; give the case a [[probe]] with at = 1, of "
                       "the position");
  const auto need = [&](const TableReader& where, const GivenRun& of) {
    for (const std::string& column : column_names(*tip))
      if (of.find(column) == nullptr)
        where.refuse_value("file",
                           fmt::format("has no column {}, which the error beside its seconds needs; name "
                                       "the file's own for it in columns",
                                       column));
  };
  if (given.seconds > 0) need(table, run);
  const std::vector<TableReader> points = table.tables("point");
  for (std::size_t p = 0; p < points.size(); ++p) need(points[p], run.points[p]);
}

}  // namespace

void check_given_runs(const std::vector<TableReader>& tables, const Case& spec,
                      const std::vector<GivenRun>& runs) {
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const GivenRunSpec& given = spec.given_runs[k];
    // Verdicts are named after both.
    for (const ReferenceUse& use : spec.references)
      if (use.name == given.name) tables[k].refuse_value("name", "is the name of a reference");
    std::unordered_set<std::string_view> there{time_column};
    for (const GivenColumn& column : runs[k].columns) there.insert(column.name);
    const auto need = [&](const std::string& column, const std::string& user, bool may_be_missing) {
      if (there.contains(column)) return;
      const auto mapped = given.columns.find(column);
      if (mapped != given.columns.end() && may_be_missing) return;
      tables[k].refuse_value(
          "columns",
          fmt::format(
              "{} has no column {}, which {} needs; {}", given.file, column, user,
              may_be_missing
                  ? fmt::format("name the file's own for it, or say that there is none by \"{}\" = \"\"",
                                column)
                  : "the run that is reported must have it"));
    };
    for (const ReferenceUse& use : spec.references)
      for (const Comparison& comparison : use.compare)
        need(column_quantity(comparison.column).column, fmt::format("the reference {}", use.name), true);
    for (const auto& [column, tolerance] : given.tolerances) need(column, "its tolerance", false);
    if (given.is_timed() && !reports_given_run(spec)) check_tip(tables[k], spec, given, runs[k]);
    const bool reported = k == 0 && reports_given_run(spec);
    for (const FigureSpec& figure : spec.figures)
      for (const std::string& column : {figure.x, figure.y})
        need(column, fmt::format("the figure {}", figure.name), !reported);
    if (reported && !given.tolerances.empty())
      tables[k].refuse_value("tolerances",
                             "the run is the one that is reported, and has no distance to itself");
  }
}

}  // namespace plumb
