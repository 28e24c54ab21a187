#pragma once

#include <array>
#include <kainjow/mustache.hpp>
#include <string>
#include <vector>

#include "report/verdict/verdict.h"

namespace plumb {

/// What a kind of verdicts is called, and what it can tell.
struct KindText {
  VerdictKind kind;
  const char* title;
  const char* evidence;
};
extern const std::array<KindText, 4> kind_texts;

/// Verdicts for the page of a run, each kind of evidence apart with what it can tell: kinds and verdicts that
/// failed first, then what was not run. `command` is what makes them again.
std::string verdict_groups(const std::vector<Verdict>& verdicts, const std::string& command);

/// The kinds in one line: {{title}}, {{counts}}, the {{class}} of the worst verdict, and {{link}}, the group
/// of verdict_groups() that has them; none where there are no such verdicts.
kainjow::mustache::data verdict_marks(const std::vector<Verdict>& verdicts);

}  // namespace plumb
