#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <filesystem>

#include "engine/base/errors.h"
#include "engine/case/case_source.h"
#include "engine/case/probe_columns.h"
#include "engine/integrate/method_info.h"
#include "engine/read/case_sections.h"
#include "engine/read/changed_case.h"
#include "engine/read/given_probes.h"
#include "engine/read/method_keys.h"
#include "engine/read/model_keys.h"
#include "engine/read/override.h"
#include "engine/read/parameters.h"
#include "engine/read/table_reader.h"

namespace plumb {
namespace {

constexpr std::size_t longest_title = 500;

/// How much of a case is read.
enum class Extent {
  everything,
  without_studies,  ///< of a case that is itself a part of a study
  motion,           ///< what the motion depends on, and neither what is compared nor what is drawn
};

/// In what the case that an external run is of moves otherwise; empty: in nothing, or it is not known.
std::string difference_of_motion(const GivenRun& run, const Case& spec) {
  if (!run.own_case) return "";
  const Case& own = *run.own_case;
  const CableSpec& cable = own.cable;
  std::string text = difference({cable.length, cable.youngs_modulus * cable.area,
                                 cable.youngs_modulus * cable.second_moment, cable.density * cable.area},
                                spec.cable, "in the file");
  for (const auto& [name, same] :
       {std::pair{"start", own.start == spec.start}, std::pair{"supports", own.supports == spec.supports},
        std::pair{"loads", own.loads == spec.loads}, std::pair{"masses", own.masses == spec.masses},
        std::pair{"damping", own.damping == spec.damping}})
    if (!same) text += fmt::format("{}its {} {}", text.empty() ? "" : "; ", name, "differ");
  return text;
}

/// Notes in each external run what it lacks of the case, and which one it repeats.
void note_shortcomings(const Case& spec, GivenRunsRead& given) {
  constexpr double rounding = 1e-9;
  std::vector<ProbeTable> tables;
  for (std::size_t k = 0; k < given.runs.size(); ++k) {
    GivenRun& run = given.runs[k];
    tables.push_back(probe(run));
    std::vector<std::string> notes;
    if (run.times.back() < spec.time.end * (1 - rounding))
      notes.push_back(fmt::format("the run in it ends at {:.6g} s, before the end of the case, {:.6g} s",
                                  run.times.back(), spec.time.end));
    if (run.times.front() > spec.time.end * rounding)
      notes.push_back(fmt::format("the run in it begins at {:.6g} s, not at 0", run.times.front()));
    if (const std::string what = difference_of_motion(run, spec); !what.empty())
      notes.push_back("the run in it is of another case: " + what);
    for (std::size_t other = 0; other < k; ++other)
      if (same_run(tables[other], tables[k]))
        notes.push_back(fmt::format("the run in it has the same numbers as {}, which it does not confirm",
                                    spec.given_runs[other].name));
    for (std::string& note : notes) {
      given.remarks.push_back(fmt::format("{}: {}", spec.given_runs[k].file, note));
      run.notes.push_back(std::move(note));
    }
  }
}

LoadedCase read_case(const NamedText& file, const TomlValue& written,
                     const std::vector<std::string>& overrides, ReferenceFiles& files, Extent extent,
                     const SectionUse& uses = use_all);

/// The case without what is read of everything only, so that to read it once more for each variant does not
/// cost all other variants.
TomlValue without_studies(const TomlValue& written) {
  TomlValue result = written;
  std::erase_if(result.items, [](const TomlValue& item) {
    return item.key == "study" || item.key == "uncertainty" || item.key == "error_budget" ||
           item.key == "sensitivity" || item.key == "run";
  });
  return result;
}

/// Reads a section; where it is not used, what is wrong with it becomes a remark.
template <class Read>
void read_section(std::string_view name, const SectionUse& uses, std::vector<std::string>& remarks,
                  Read read) {
  if (uses(name)) return read();
  try {
    read();
  } catch (const InputError& error) {
    remarks.push_back(fmt::format("[{}] is not used here, and could not be: {}", name, error.what()));
  }
}

void read_studies(TableReader study, const NamedText& file, const TomlValue& written,
                  const std::vector<std::string>& overrides, ReferenceFiles& files, const SectionUse& uses,
                  LoadedCase& loaded) {
  Case& spec = loaded.spec;
  const bool has_work_precision = study.has("work_precision");
  const bool has_stability = study.has("stability");
  const bool has_sweep = study.has("sweep");
  const bool has_economy = study.has("economy");
  const std::vector<TableReader> variants = study.tables("variant");
  study.finish();
  const auto section = [&](std::string_view name, auto read) {
    read_section(name, uses, loaded.remarks, read);
  };
  if (has_work_precision)
    section("study.work_precision", [&] {
      spec.work_precision = read_work_precision(study.table("work_precision"), spec.cable, spec.time);
    });
  if (has_stability)
    section("study.stability", [&] {
      spec.stability = read_stability(study.table("stability"), spec.parameters, spec.cable, spec.time);
    });
  if (has_sweep) section("study.sweep", [&] { spec.sweep = read_sweep(study.table("sweep"), spec.cable); });
  if (has_economy)
    section("study.economy", [&] { spec.economy = read_economy(study.table("economy"), spec.scene); });
  if (variants.empty()) return;
  const TomlValue bare = without_studies(written);
  section("study.variant", [&] {
    spec.variants = read_variants(variants, [&](const std::vector<std::string>& more) {
      std::vector<std::string> all = overrides;
      all.insert(all.end(), more.begin(), more.end());
      return read_case(file, bare, all, files, Extent::without_studies).spec;
    });
  });
}

LoadedCase read_case(const NamedText& file, const std::vector<std::string>& overrides, ReferenceText text_of,
                     NamesOfFiles names_of, Extent extent, const SectionUse& uses = use_all) {
  ReferenceFiles files(std::move(text_of), std::move(names_of));
  return read_case(file, parse_toml(file), overrides, files, extent, uses);
}

LoadedCase read_case(const NamedText& file, const TomlValue& written,
                     const std::vector<std::string>& overrides, ReferenceFiles& files, Extent extent,
                     const SectionUse& uses) {
  TomlValue merged = written;
  for (const std::string& text : overrides) apply_override(merged, text);

  LoadedCase loaded;
  loaded.uses = uses;
  loaded.remarks = drop_overruled_keys(written, merged);
  for (std::string& remark : drop_keys_of_other_models(merged)) loaded.remarks.push_back(std::move(remark));
  const Parameters parameters(merged.find("parameters"));
  TableReader root(merged, "", &parameters);
  root.has("parameters");

  // All tables are asked for before any is read: an unknown one is likely the reason why another is missing.
  Case& spec = loaded.spec;
  spec.title = root.text("title", "a title");
  if (spec.title.size() > longest_title)
    root.refuse_value("title", fmt::format("must be at most {} bytes long", longest_title));
  const TableReader cable = root.required_table("cable", "a table [cable]"), start = root.table("start");
  const TableReader supports = root.table("supports"), loads = root.table("loads");
  const std::vector<TableReader> applied = root.tables("load"), masses = root.tables("mass");
  const TableReader damping = root.table("damping");
  std::vector<TableReader> runs = root.tables("run");
  const bool given_only = extent == Extent::everything && !runs.empty() && !root.has("method");
  const MethodInfo* named = named_method(merged);
  const bool timeless = named != nullptr && named->timeless;
  const TableReader method = given_only ? root.table("method")
                                        : root.required_table(
                                              "method", "a table [method], or a [[run]] that was computed"),
                    time = given_only || timeless ? root.table("time")
                                                  : root.required_table("time", "a table [time]");
  const std::vector<TableReader> probes = root.tables("probe"), references = root.tables("reference");
  const std::vector<TableReader> figures = root.tables("figure");
  const TableReader scene = root.table("scene");
  const TableReader study = root.table("study"), uncertainty = root.table("uncertainty");
  const TableReader error_budget = root.table("error_budget"), sensitivity = root.table("sensitivity");
  const bool has_uncertainty = root.has("uncertainty"), has_error_budget = root.has("error_budget"),
             has_sensitivity = root.has("sensitivity");
  root.finish();

  spec.parameters = parameters.values();
  spec.cable = read_cable(cable, !given_only);
  spec.start = read_start(start);
  spec.supports = read_supports(supports, spec.cable.model, parameters);
  spec.loads = read_loads(loads, applied, spec.cable.model, spec.start.direction, parameters);
  spec.masses = read_masses(masses);
  spec.damping = read_damping(damping, spec.cable.model);
  if (extent != Extent::motion) spec.probes = read_probes(probes);
  GivenRunsRead given;
  if (extent == Extent::everything)
    given = read_given_runs(runs, file.name, files.text_of(), files.names_of(), spec.probes);
  spec.given_runs = std::move(given.specs);
  if (given_only) {
    const double last = given.runs.front().times.back();
    if (!(last > 0)) runs.front().refuse_value("file", fmt::format("ends at {} s; must end after 0 s", last));
    spec.time = read_time(time, last);
  } else {
    // What is asked for once needs no times; of loads that change with it there is an end of a second.
    constexpr double any_end = 1;
    spec.time = read_time(time, timeless ? std::optional(any_end) : std::nullopt);
    spec.method = read_method(method, spec.time);
  }
  check_factors(applied, spec);
  check_motion(supports, spec);
  check_damping(damping, spec);
  if (spec.cable.model == CableModel::rigid) check_rigid(spec, {start, method, probes});
  // The method of an external run is not known, nor yet the one that is left to the scene.
  const MethodInfo* info = find_method(spec.method.name);
  if (info != nullptr && !info->dynamic) check_frame(start, supports, loads, applied, damping, spec);
  if (spec.start.imperfection != 0) check_imperfection(spec, start);
  if (extent == Extent::motion) return loaded;
  const Abscissa own = timeless                            ? Abscissa::mode
                       : info != nullptr && !info->dynamic ? Abscissa::load
                                                           : Abscissa::time;
  if (timeless)
    for (std::size_t k = 0; k < probes.size(); ++k)
      for (const ModeColumn& column : mode_columns())
        if (spec.probes[k].name == column.name)
          probes[k].refuse_value("name", "is the name of what every mode has");
  ReferencesRead read = read_references(references, file.name, files, spec.probes, spec.time, own);
  spec.references = std::move(read.uses);
  spec.figures = read_figures(figures, spec.probes, spec.references, timeless);
  // A scene that the method is left to is used whatever is made of the run.
  const bool asks_scene = spec.method.name == scene_method;
  const auto section = [&](std::string_view name, auto part) {
    read_section(name, asks_scene ? use_all : uses, loaded.remarks, part);
  };
  section("scene", [&] { spec.scene = read_scene(scene, spec.time); });
  const std::string no_motion =
      fmt::format("is of motions over time, which {} has none of", spec.method.name);
  if (extent == Extent::everything) {
    if (timeless && root.has("run"))
      root.refuse_value("run", fmt::format("{}; leave the table out", no_motion));
    check_given_runs(runs, spec, given.runs);
    note_shortcomings(spec, given);
    if (given_only)
      for (const char* key : {"study", "uncertainty", "error_budget", "sensitivity"})
        if (root.has(key))
          root.refuse_value(key, "belongs to runs of Plumb's own; a case without [method] has none");
    read_studies(study, file, written, overrides, files, uses, loaded);
    if (has_uncertainty)
      section("uncertainty", [&] {
        if (timeless) root.refuse_value("uncertainty", no_motion);
        spec.uncertainty = read_uncertainty(uncertainty, spec);
      });
    if (has_error_budget)
      section("error_budget", [&] {
        if (timeless) root.refuse_value("error_budget", no_motion);
        spec.error_budget =
            read_error_budget(error_budget, spec.references, [&](const std::vector<std::string>& more) {
              return read_case(file, written, joined_overrides(overrides, more), files, Extent::motion).spec;
            });
      });
    if (has_sensitivity)
      section("sensitivity", [&] { spec.sensitivity = read_sensitivity(sensitivity, spec); });
  }

  loaded.references = std::move(read.references);
  loaded.given_runs = std::move(given.runs);
  loaded.source = {file, overrides, std::move(read.texts), std::move(given.texts)};
  loaded.remarks.insert(loaded.remarks.end(), read.remarks.begin(), read.remarks.end());
  loaded.remarks.insert(loaded.remarks.end(), given.remarks.begin(), given.remarks.end());
  for (const std::string& name : parameters.unused()) {
    loaded.remarks.push_back(fmt::format("parameters.{} is not used", name));
  }
  return loaded;
}

/// Gives the texts of references and external runs that a source holds, which must outlive it.
ReferenceText texts_of(const CaseSource& source) {
  return [&](const std::string& name, InputKind) {
    for (const auto* files : {&source.references, &source.given_runs})
      for (const NamedText& file : *files)
        if (file.name == name) return FileText{file.text, ""};
    return FileText{"", "its text is not among those of the case"};
  };
}

/// Whether a name stands for several files by what it is: a pattern in its last part.
bool is_pattern(const std::string& file) {
  return file.find_first_of("*?[") != std::string::npos;
}

bool belongs_to_pattern(const std::string& name, const std::string& pattern) {
  return ::fnmatch(pattern.c_str(), name.c_str(), FNM_PATHNAME | FNM_PERIOD) == 0;
}

/// The same of files on the disk, below the folder of a case.
NamesOfFiles names_on_disk(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  return [folder](const std::string& file) -> std::optional<std::vector<std::string>> {
    std::error_code error;
    const bool is_folder = fs::is_directory(folder / file, error);
    if (fs::exists(folder / file, error) ? !is_folder : !is_pattern(file)) return {};
    std::vector<std::string> names;
    const fs::path below = is_folder ? fs::path(file) : fs::path(file).parent_path();
    for (fs::directory_iterator entry(folder / (below.empty() ? "." : below), error), end;
         !error && entry != end; entry.increment(error)) {
      const std::string name = (below / entry->path().filename()).string();
      const bool wanted =
          is_folder ? !entry->path().filename().string().starts_with('.') : belongs_to_pattern(name, file);
      if (wanted && entry->is_regular_file(error)) names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
  };
}

/// The same of the files that a source holds, which must outlive it.
NamesOfFiles names_in(const CaseSource& source) {
  return [&](const std::string& file) -> std::optional<std::vector<std::string>> {
    std::vector<std::string> names;
    for (const NamedText& run : source.given_runs) {
      if (run.name == file) return {};
      const std::filesystem::path below = std::filesystem::path(run.name).parent_path();
      if ((is_pattern(file) && belongs_to_pattern(run.name, file)) ||
          below.lexically_normal() == (std::filesystem::path(file) / "").lexically_normal().parent_path())
        names.push_back(run.name);
    }
    if (names.empty()) return {};
    std::sort(names.begin(), names.end());
    return names;
  };
}

}  // namespace

LoadedCase::LoadedCase() = default;
LoadedCase::LoadedCase(const LoadedCase&) = default;
LoadedCase::LoadedCase(LoadedCase&&) noexcept = default;
LoadedCase& LoadedCase::operator=(const LoadedCase&) = default;
LoadedCase& LoadedCase::operator=(LoadedCase&&) noexcept = default;
LoadedCase::~LoadedCase() = default;

bool use_all(std::string_view) {
  return true;
}

LoadedCase load_case(const std::string& path, const std::vector<std::string>& overrides,
                     const SectionUse& uses) {
  const std::string text = read_whole_file(path, InputKind::case_file);
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  return read_case(
      {path, text}, overrides,
      [&](const std::string& name, InputKind kind) { return read_file_text((folder / name).string(), kind); },
      names_on_disk(folder), Extent::everything, uses);
}

LoadedCase load_case(const CaseSource& source, const SectionUse& uses) {
  return read_case(source.file, source.overrides, texts_of(source), names_in(source), Extent::everything,
                   uses);
}

LoadedCase load_without_studies(const CaseSource& source) {
  return read_case(source.file, source.overrides, texts_of(source), names_in(source),
                   Extent::without_studies);
}

LoadedCase load_variant(const CaseSource& source, const VariantSpec& variant) {
  return load_without_studies(source.with(variant.overrides));
}

LoadedCase load_changed(const CaseSource& source, const std::vector<std::string>& overrides) {
  return read_case(source.file, joined_overrides(source.overrides, overrides), texts_of(source),
                   names_in(source), Extent::without_studies);
}

}  // namespace plumb
