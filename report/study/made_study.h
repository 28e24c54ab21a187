#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/study/estimate.h"
#include "engine/study/runner.h"
#include "report/figure/pictures.h"
#include "report/study/study_report.h"

namespace plumb {

/// A line of what a study found, for the terminal.
struct Finding {
  enum class Mood { plain, good, bad, faint };
  std::string text;
  std::string mark = {};  ///< before the text, in the colour of `mood`
  Mood mood = Mood::plain;
};

/// A study that was made, or read from its file, as its report needs it.
class MadeStudy {
 public:
  virtual ~MadeStudy() = default;
  virtual std::string title() const = 0;
  /// The file that it can be read from again: name and bytes.
  virtual std::pair<std::string, std::string> file() const = 0;
  virtual std::vector<Figure> figures() const = 0;
  /// Drawn into the folder, but not on the page.
  virtual std::vector<Figure> figures_beside() const { return {}; }
  virtual StudyReport report(const Stages& stages) const = 0;
  virtual StudySection section(const std::vector<Picture>& pictures) const = 0;
  /// Said before the verdicts.
  virtual std::vector<Finding> findings() const = 0;
  /// False where the findings are the verdicts.
  virtual bool says_verdicts() const { return true; }
};

/// The file of every kind of study but that of work and precision. Its `kind` is the name of the kind, its
/// `version` a number.
inline constexpr const char* study_json_name = "study.json";

/// A kind of study: `plumb study CASE KIND`.
struct StudyKind {
  std::string name;                      ///< "work-precision"
  std::string folder;                    ///< what the default output folder has after the case's name
  bool (*asked_for)(const Case& spec);   ///< the case has its table
  bool asks_what_a_scene_needs = false;  ///< for others, that is the answer to start from
  StudyEstimate estimate;                ///< of what it takes of the machine
  std::string_view schema;               ///< JSON Schema of what results.json has under its name
  /// Throws InputError where the case has nothing for it.
  std::unique_ptr<MadeStudy> (*make)(const LoadedCase& loaded, Runner& runner);
  /// From the text of study.json, which names this kind; nullptr for a study that is kept in study.h5. Throws
  /// InputError, naming the file, for anything that it does not write.
  std::unique_ptr<MadeStudy> (*read)(const std::string& json, const std::string& file);
  bool takes_rigid = false;  ///< has something to ask of a rigid rod, without methods and meshes
};

}  // namespace plumb
