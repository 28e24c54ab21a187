#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/case/case_source.h"
#include "engine/run/output_folder.h"
#include "engine/study/runner.h"
#include "report/base/stages.h"
#include "report/program/console.h"
#include "report/program/options.h"

namespace plumb {

/// A kind of study: `plumb study CASE KIND`.
struct StudyKind {
  std::string name;                     ///< "work-precision"
  std::string folder;                   ///< what the default output folder has after the case's name
  bool (*asked_for)(const Case& spec);  ///< the case has its table
  /// Makes the study and its report.
  ExitStatus (*study)(const LoadedCase& loaded, Runner& runner, OutputFolder& folder, Stages& stages,
                      const Options& options, Talk& talk);
  /// Makes the report anew from the text of study.json, which names this kind; nullptr for a study that is
  /// kept in study.h5.
  ExitStatus (*report)(const std::string& json, OutputFolder& folder, Stages& stages, const Options& options,
                       Talk& talk);
};

/// Every kind; the first one serves where a case asks for none.
std::span<const StudyKind> study_kinds();
std::vector<std::string> study_kind_names();

/// The kind that options and case ask for. Throws UsageError for a word that is none.
const StudyKind& chosen_study_kind(const Options& options, const Case& spec);

/// The name of the file that studies other than work-precision keep their result in. Its `kind` is the name
/// of the kind, its `version` a number.
inline constexpr const char* study_json_name = "study.json";

/// The study.json at a path: the file itself, or that in a folder without a run.h5. Throws InputError where
/// it cannot be read.
std::optional<NamedText> study_json_at(const std::string& path);

/// The kind that it names. Throws InputError where it is no study of this program.
const StudyKind& kind_of_study_json(const NamedText& json);

ExitStatus work_precision_study(const LoadedCase& loaded, Runner& runner, OutputFolder& folder,
                                Stages& stages, const Options& options, Talk& talk);
ExitStatus sweep_study(const LoadedCase& loaded, Runner& runner, OutputFolder& folder, Stages& stages,
                       const Options& options, Talk& talk);
ExitStatus sweep_report(const std::string& json, OutputFolder& folder, Stages& stages, const Options& options,
                        Talk& talk);

/// Throws InputError where the case has no variants.
ExitStatus variants_study(const LoadedCase& loaded, Runner& runner, OutputFolder& folder, Stages& stages,
                          const Options& options, Talk& talk);
ExitStatus variants_report(const std::string& json, OutputFolder& folder, Stages& stages,
                           const Options& options, Talk& talk);

ExitStatus economy_study(const LoadedCase& loaded, Runner& runner, OutputFolder& folder, Stages& stages,
                         const Options& options, Talk& talk);
ExitStatus economy_report(const std::string& json, OutputFolder& folder, Stages& stages,
                          const Options& options, Talk& talk);

ExitStatus stability_study(const LoadedCase& loaded, Runner& runner, OutputFolder& folder, Stages& stages,
                           const Options& options, Talk& talk);
ExitStatus stability_report(const std::string& json, OutputFolder& folder, Stages& stages,
                            const Options& options, Talk& talk);

}  // namespace plumb
