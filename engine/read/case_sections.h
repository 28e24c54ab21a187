#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/file_text.h"
#include "engine/case/case.h"
#include "engine/case/case_source.h"
#include "engine/read/changed_case.h"
#include "engine/read/table_reader.h"

// The sections of a case file, one function each. Each reads its table to the end and checks all that can be
// checked with what it is given. All throw InputError.
namespace plumb {

/// Without `elements` where the run that is reported is a given one, which has no mesh: 0 then.
CableSpec read_cable(TableReader table, bool has_mesh = true);
StartSpec read_start(TableReader table);
SupportsSpec read_supports(TableReader table, CableModel model, const Parameters& parameters);
/// Refuses a motion of a support that is not 0 at first, not finite or not smooth in the run, or which the
/// method does not take.
void check_motion(TableReader table, const Case& spec);
/// [loads] and the [[load]] tables, of a cable that starts in `direction`.
LoadsSpec read_loads(TableReader table, std::vector<TableReader> applied, CableModel model,
                     const Vec3& direction, const Parameters& parameters);
/// Refuses a [[load]] whose factor is not a finite number at all times of the run.
void check_factors(const std::vector<TableReader>& applied, const Case& spec);
std::vector<MassSpec> read_masses(std::vector<TableReader> tables);
/// Refuses what a model and a method cannot take of `table`.
DampingSpec read_damping(TableReader table, CableModel model);
/// Refuses what a method that integrates no motion cannot take of it; what cannot turn with a frame of that
/// spin: loads across its axis, drag, and what a method that takes no spin cannot have of the start.
void check_frame(const TableReader& start, const TableReader& supports, const TableReader& loads,
                 const std::vector<TableReader>& applied, const TableReader& damping, const Case& spec);
/// Refuses damping for a method that is made for forces without rates.
void check_damping(const TableReader& table, const Case& spec);
/// `end` (s) is where the time ends unless the table says so.
TimeSpec read_time(TableReader table, std::optional<double> end = {});

/// [method]: the method's keys and no other, with defaults filled in.
MethodSpec read_method(TableReader table, const TimeSpec& time);

std::vector<ProbeSpec> read_probes(std::vector<TableReader> tables);

/// `coverage`, an empty table: all. `times` (s) are those that it is of; one after 0 must be left of them.
CoverageSpec read_coverage(TableReader table, const std::vector<double>& times, const std::string& whose);

/// What [[reference]] says and the files it names, in the same order.
struct ReferencesRead {
  std::vector<ReferenceUse> uses;
  std::vector<Reference> references;
  std::vector<NamedText> texts;  ///< one a file
  std::vector<std::string> remarks;
};

/// Gives the text of a reference or external run by its `file` key, or why there is none.
using ReferenceText = std::function<FileText(const std::string& file, InputKind kind)>;

/// The files of a folder, or those that a pattern stands for ("runs/*.csv"), relative to the case and sorted;
/// nothing for the name of one file.
using NamesOfFiles = std::function<std::optional<std::vector<std::string>>(const std::string& file)>;

/// The reference files of a case, each read once however often the case is, as for each of its variants.
class ReferenceFiles {
 public:
  ReferenceFiles(ReferenceText text_of, NamesOfFiles names_of)
      : text_of_(std::move(text_of)), names_of_(std::move(names_of)) {}
  /// By a reference's `file` key.
  const FileText& text(const std::string& file);
  /// The same, checked; errors show it by the other name. Throws InputError.
  const Reference& reference(const std::string& file, const std::string& shown_name);
  const ReferenceText& text_of() const { return text_of_; }
  const NamesOfFiles& names_of() const { return names_of_; }

 private:
  struct File {
    std::optional<FileText> text;
    std::optional<Reference> reference;
  };
  ReferenceText text_of_;
  NamesOfFiles names_of_;
  std::map<std::string, File> files_;
};

/// The most [[reference]] tables, and the most [[run]] tables, of a case.
inline constexpr std::size_t most_files = 100;

/// `case_name` is the case file's own: errors within a reference name it relative to the same folder. `own`:
/// what a run of the case has, beside times loads where that is `load`.
ReferencesRead read_references(std::vector<TableReader> tables, const std::string& case_name,
                               ReferenceFiles& files, const std::vector<ProbeSpec>& probes,
                               const TimeSpec& time, Abscissa own);

/// What [[run]] says and the runs it names, in the same order.
struct GivenRunsRead {
  std::vector<GivenRunSpec> specs;
  std::vector<GivenRun> runs;
  std::vector<NamedText> texts;  ///< one a file
  std::vector<std::string> remarks;
};

/// Of a table whose `file` stands for many there is one an external run in `tables` then.
GivenRunsRead read_given_runs(std::vector<TableReader>& tables, const std::string& case_name,
                              const ReferenceText& text_of, const NamesOfFiles& names_of,
                              const std::vector<ProbeSpec>& probes);

/// Refuses an external run that lacks a column which a comparison or a figure of the case needs, unless its
/// table says that there is none.
void check_given_runs(const std::vector<TableReader>& tables, const Case& spec,
                      const std::vector<GivenRun>& runs);

std::vector<FigureSpec> read_figures(std::vector<TableReader> tables, const std::vector<ProbeSpec>& probes,
                                     const std::vector<ReferenceUse>& references, bool of_modes);

SceneSpec read_scene(TableReader table, const TimeSpec& time);
/// A camera that is told where to stand.
CameraSpec read_camera(TableReader table);

/// [study.work_precision]; an empty table gives the defaults.
WorkPrecisionSpec read_work_precision(TableReader table, const CableSpec& cable, const TimeSpec& time);

/// [study.stability]; an empty table gives the defaults.
StabilitySpec read_stability(TableReader table, const std::map<std::string, double>& parameters,
                             const CableSpec& cable, const TimeSpec& time);

/// The stability study of a case: what its table says, or the defaults where it has none, of the methods that
/// take the case.
StabilitySpec stability_of(const Case& spec);

/// [study.sweep]; an empty table gives the defaults.
SweepSpec read_sweep(TableReader table, const CableSpec& cable);

/// Refuses a key `tolerance` (m) of a study that calls runs accurate beyond the length of the cable, as
/// hardly any run is further off than that.
void check_accuracy(const TableReader& table, double tolerance, const CableSpec& cable);
SweepSpec default_sweep(const CableSpec& cable);

/// [study.economy]; an empty table gives the defaults.
EconomySpec read_economy(TableReader table, const SceneSpec& scene);
EconomySpec default_economy(const SceneSpec& scene);

/// [[study.variant]]; the case of each is read by `with`, and refused where it is not valid.
std::vector<VariantSpec> read_variants(std::vector<TableReader> tables, const CaseWithOverrides& with);

/// [uncertainty], of a case whose other sections have been read.
UncertaintySpec read_uncertainty(TableReader table, const Case& spec);

/// [error_budget], of a case whose references have been read; the case of each item, alone and all together,
/// is read by `with`, and refused where it is not valid.
BudgetSpec read_error_budget(TableReader table, const std::vector<ReferenceUse>& references,
                             const CaseWithOverrides& with);

/// [sensitivity], of a case whose other sections have been read; an empty table gives the defaults.
SensitivitySpec read_sensitivity(TableReader table, const Case& spec);
SensitivitySpec default_sensitivity(const Case& spec);

}  // namespace plumb
