#pragma once

#include <concepts>
#include <string_view>
#include <type_traits>
#include <vector>

#include "engine/case/range.h"

namespace plumb {

/// A key of a table of a case: all that reading, storing and showing it needs. Each table's struct is
/// followed by its `visit_keys(spec, visit)`, which calls `visit(const Key&, field)` for each. A field has
/// the key's default.
struct Key {
  std::string_view name;
  std::string_view meaning = {};  ///< "density ρ": what the page of a report calls it
  Range range = {};               ///< of a number, or of those in a list, with the unit
  bool required = false;          ///< has no default
  /// Says how Plumb computes the motion, which is neither asked of nor known of an external run.
  bool of_computation = false;
  bool not_of_chain = false;  ///< means nothing to a cable of that model
  bool not_of_rigid = false;  ///< likewise
};

/// A struct of a case, constant or not.
template <class T, class Spec>
concept SpecOf = std::same_as<std::remove_const_t<T>, Spec>;

/// The keys of a table, in order.
template <class Spec>
std::vector<Key> keys_of() {
  std::vector<Key> keys;
  const Spec spec;
  visit_keys(spec, [&](const Key& key, const auto&) { keys.push_back(key); });
  return keys;
}

}  // namespace plumb
