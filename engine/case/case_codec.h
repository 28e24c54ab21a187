#pragma once

#include <string>

#include "engine/base/codec.h"
#include "engine/case/case_words.h"

/// The tables of a case in JSON, by their keys.
namespace plumb {

template <class Archive, class Spec>
requires requires(Spec& spec) {
  visit_keys(spec, [](const Key&, auto&) {});
}
void members(Archive& a, Spec& spec) {
  visit_keys(spec, [&](const Key& key, auto& field) { a(std::string(key.name).c_str(), field); });
}

/// The values of an enumeration that case files have words for.
template <class E>
requires(!words_of<E>.empty()) auto enum_values(E) {
  std::array<E, words_of<E>.size()> values;
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = words_of<E>[k].value;
  return values;
}

}  // namespace plumb
