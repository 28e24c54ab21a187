#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/case/case.h"
#include "engine/case/given_run.h"
#include "engine/case/reference.h"

namespace plumb {

/// A text with the name that errors show for it.
struct NamedText {
  std::string name;  ///< "cases/pendulum.toml"
  std::string text;
};

/// All that a case is made of, so that it can be read again from a run file where its files no longer are.
struct CaseSource {
  NamedText file;
  std::vector<std::string> overrides;      ///< "cable.elements=8", as after --set
  std::vector<NamedText> references;       ///< text of each [[reference]] file, named by its `file` key
  std::vector<NamedText> given_runs = {};  ///< bytes of each [[run]] file, named by its `file` key

  /// The same with further overrides after its own.
  CaseSource with(const std::vector<std::string>& more) const {
    CaseSource changed = *this;
    changed.overrides.insert(changed.overrides.end(), more.begin(), more.end());
    return changed;
  }
};

/// Whether something is made of a section that not all commands use: "scene", "uncertainty", "error_budget",
/// "sensitivity", "study.sweep" and so on. What is wrong in one that is not used is a remark, and the section
/// left out.
using SectionUse = std::function<bool(std::string_view section)>;
bool use_all(std::string_view section);

/// A checked case with the references and runs that it names, in the orders of `Case`.
struct LoadedCase {
  CaseSource source;
  Case spec;
  std::vector<Reference> references;
  std::vector<GivenRun> given_runs;  ///< in the order of `Case::given_runs`
  std::vector<std::string> remarks;  ///< what was left unused and why, for the user to see
  SectionUse uses = use_all;         ///< what it was read for

  // Compiled once, as they are long and many use them.
  LoadedCase();
  LoadedCase(const LoadedCase&);
  LoadedCase(LoadedCase&&) noexcept;
  LoadedCase& operator=(const LoadedCase&);
  LoadedCase& operator=(LoadedCase&&) noexcept;
  ~LoadedCase();
};

/// Reads a case file from disk with its references and checks everything.
/// Throws InputError naming file, line, column, the value and what is allowed.
LoadedCase load_case(const std::string& path, const std::vector<std::string>& overrides = {},
                     const SectionUse& uses = use_all);

/// The same from texts that are at hand already. Throws as above.
LoadedCase load_case(const CaseSource& source, const SectionUse& uses = use_all);

/// The case of a [[study.variant]]: that of the source with the variant's overrides after its own, and
/// without studies. Throws as above.
LoadedCase load_variant(const CaseSource& source, const VariantSpec& variant);

/// Reads a reference. Throws InputError where source, figure, unit, how obtained or uncertainty is missing,
/// or a number is not finite.
Reference read_reference(const NamedText& text);

}  // namespace plumb
