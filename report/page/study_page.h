#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/case/case_source.h"
#include "engine/run/provenance.h"
#include "report/base/stages.h"
#include "report/verdict/verdict.h"

namespace plumb {

struct Picture;

/// What the pages of studies have around the study itself.
struct StudyShell {
  std::string title;    ///< of the case
  std::string subject;  ///< "speed against accuracy"
  std::string headline;
  bool good = false;  ///< how the headline looks
  /// Sections of the study with their ids: {"study-time", "Time integration"}.
  std::vector<std::pair<std::string, std::string>> sections;
  std::string section;        ///< HTML
  std::string css;            ///< beside that of every page
  std::string scripts;        ///< HTML, for the end of the body
  std::string script_policy;  ///< the directive that lets just those run
  std::string verdict_note;   ///< HTML, below the verdicts
};

/// The whole page: one file that opens offline.
std::string study_shell(const StudyShell& shell, const std::vector<Verdict>& verdicts,
                        const CaseSource& source, const Provenance& provenance, const Stages& stages);

/// "script-src 'sha256-…' …" for scripts whose SHA-256 are given in hexadecimal.
std::string script_policy(const std::vector<std::string_view>& hashes);

/// A script element.
std::string script_element(std::string_view text);

/// JSON for scripts, which find it by its id.
std::string data_element(const std::string& id, const std::string& json);

/// The picture of that name among those drawn, or nullptr.
const Picture* find_picture(const std::vector<Picture>& pictures, const std::string& name);

}  // namespace plumb
