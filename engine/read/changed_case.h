#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/case/case_source.h"
#include "engine/read/table_reader.h"

namespace plumb {

/// Reads the case again with further overrides.
using CaseWithOverrides = std::function<Case(const std::vector<std::string>& overrides)>;

/// A table `set` of a case file: keys of the case with the values that a part of a study gives them.
class CaseChanges {
 public:
  /// Collects the table `set` of `owner`, which must outlive this. Dotted keys and quoted ones are alike:
  /// { method.step = 0.2 } and { "method.step" = 0.2 }. `whom` is who sets them, in errors: "the variant
  /// \"a\"".
  CaseChanges(TableReader& owner, std::string whom);

  /// "method.step=0.2", as --set takes them.
  std::vector<std::string> overrides() const;

  /// The keys that are set, in order: "method.step".
  std::vector<std::string> keys() const;

  /// Refuses every key that is a table of `closed`, or in one, with `what`. Throws InputError.
  void refuse_keys_in(const std::vector<std::string>& closed, std::string_view what) const;
  /// Refuses one of keys(). Throws InputError.
  [[noreturn]] void refuse_key(std::string_view key, std::string_view what) const;

  /// The case with these changes after those `before`. Throws InputError, at the key that is wrong where it
  /// is one of these, for a case that is not valid.
  Case read(const CaseWithOverrides& with, const std::vector<std::string>& before = {}) const;

 private:
  struct Change {
    const TomlValue* value;
    std::string key;
    std::string override_text;
  };
  void collect(const TomlValue& table, const std::string& before);

  const TableReader* owner_;
  std::string whom_;
  std::vector<Change> changes_;
};

/// Overrides, and then more of them. Where these name a method, what was set of the method before goes: the
/// keys of one method are not those of another.
std::vector<std::string> joined_overrides(std::vector<std::string> before,
                                          const std::vector<std::string>& more);

/// The case of a source without its studies, uncertainty and error budget, which are not read. Throws
/// InputError or UsageError where it is not valid.
LoadedCase load_without_studies(const CaseSource& source);

/// The same with further overrides, joined with those of the source.
LoadedCase load_changed(const CaseSource& source, const std::vector<std::string>& overrides);

}  // namespace plumb
