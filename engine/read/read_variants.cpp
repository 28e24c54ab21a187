#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "engine/base/nearest.h"
#include "engine/case/column_quantity.h"
#include "engine/case/probe_columns.h"
#include "engine/case/variant_quantities.h"
#include "engine/integrate/trajectory.h"
#include "engine/read/case_sections.h"
#include "engine/read/changed_case.h"

namespace plumb {
namespace {

constexpr std::size_t longest_name = 80;

std::vector<std::string> possible_outcomes() {
  std::vector<std::string> words;
  for (const Outcome outcome : {Outcome::completed, Outcome::unstable, Outcome::diverged,
                                Outcome::no_convergence, Outcome::singular, Outcome::unstable_equilibrium})
    words.emplace_back(word(outcome));
  return words;
}

void check_quantity(const TableReader& table, const ExpectationSpec& expected, const Case& spec) {
  std::vector<std::string> known;
  for (const VariantQuantity& quantity : variant_quantities()) known.emplace_back(quantity.name);
  if (std::find(known.begin(), known.end(), expected.quantity) != known.end()) {
    if (expected.quantity == "growth" && spec.probes.empty())
      table.refuse_value("quantity", "needs a [[probe]], whose first column it is of");
    return;
  }
  const std::vector<std::string> columns = all_columns(spec.probes);
  const std::string column = column_quantity(expected.quantity).column;
  if (std::find(columns.begin(), columns.end(), column) != columns.end()) return;
  known.insert(known.end(), columns.begin(), columns.end());
  table.refuse_value(
      "quantity",
      fmt::format("must be {}, a column of the probes, or one of these words before a column: {}{}",
                  fmt::join(known.begin(), known.begin() + std::ssize(variant_quantities()), ", "),
                  aggregate_words(), suggestion(column, known)));
}

ExpectationSpec read_expectation(TableReader& table, const Case& spec) {
  ExpectationSpec expected;
  expected.quantity = table.text("quantity", "what is expected");
  expected.from = table.optional_text("from", "");
  expected.value = table.number("value", Range::any(""));
  expected.within = table.number("within", Range::positive("in the unit of the quantity"));
  expected.source = table.prose("source", "where the value is from");
  table.finish();
  check_quantity(table, expected, spec);
  const bool distance = expected.quantity == "distance";
  if (distance && expected.from.empty())
    table.refuse_value("from", "missing; required: the name of the variant that the distance is to");
  if (!distance && !expected.from.empty())
    table.refuse_value("from", "belongs to the quantity \"distance\" alone");
  return expected;
}

/// A variant with its case, and the tables that its expectations are in.
struct Read {
  VariantSpec variant;
  Case spec;
  std::vector<TableReader> expectations;
};

Read read_variant(TableReader& table, const CaseWithOverrides& with) {
  Read read;
  VariantSpec& variant = read.variant;
  variant.name = table.text("name", "a name");
  const CaseChanges changes(table, fmt::format("the variant \"{}\"", variant.name));
  const std::vector<std::string> outcome_words = possible_outcomes();
  if (const auto outcome = table.choice("outcome", outcome_words, true))
    variant.outcome = outcome_words[*outcome];
  variant.says = table.optional_text("says", "");
  variant.reason = table.optional_prose("reason");
  // Plain numbers: an expression would have the parameters of the file, which the variant may have changed.
  const std::vector<TableReader> expectations = table.tables("expect");
  for (std::size_t k = 0; k < expectations.size(); ++k)
    read.expectations.emplace_back(expectations[k].value(), table.full_key(fmt::format("expect.{}", k)),
                                   nullptr);
  table.finish();
  if (variant.name.size() > longest_name)
    table.refuse_value("name", fmt::format("must be at most {} bytes long", longest_name));
  if (variant.outcome == word(Outcome::completed) && !variant.says.empty())
    table.refuse_value("says", "a run that completes has no message");

  changes.refuse_keys_in({"study", "uncertainty", "error_budget", "sensitivity"}, "a variant has no studies");
  variant.overrides = changes.overrides();
  read.spec = changes.read(with);
  for (TableReader& expectation : read.expectations)
    variant.expectations.push_back(read_expectation(expectation, read.spec));
  // What a run that failed came to may be as expected by chance.
  if (variant.outcome.empty() && variant.says.empty() && !variant.expectations.empty())
    variant.outcome = word(Outcome::completed);
  return read;
}

/// A distance is between the nodes of two variants.
void check_distances(const std::vector<Read>& all,
                     const std::unordered_map<std::string, const Read*>& by_name, const Read& one) {
  for (std::size_t k = 0; k < one.variant.expectations.size(); ++k) {
    const std::string& from = one.variant.expectations[k].from;
    if (from.empty()) continue;
    const auto found = by_name.find(from);
    const Read* other = found == by_name.end() || found->second == &one ? nullptr : found->second;
    const TableReader& table = one.expectations[k];
    if (other == nullptr) {
      std::vector<std::string> others;
      for (const Read& any : all)
        if (&any != &one) others.push_back(any.variant.name);
      table.refuse_value("from", "is the name of no other variant" + suggestion(from, others));
    }
    if (other->spec.cable.elements != one.spec.cable.elements)
      table.refuse_value("from", fmt::format("has {} elements, this variant {}: their nodes are not the same",
                                             other->spec.cable.elements, one.spec.cable.elements));
  }
}

}  // namespace

std::vector<VariantSpec> read_variants(std::vector<TableReader> tables, const CaseWithOverrides& with) {
  std::vector<Read> all;
  std::unordered_set<std::string> names;
  for (TableReader& table : tables) {
    Read read = read_variant(table, with);
    if (!names.insert(read.variant.name).second) table.refuse_value("name", "is the name of another variant");
    all.push_back(std::move(read));
  }
  std::unordered_map<std::string, const Read*> by_name;
  for (const Read& read : all) by_name.emplace(read.variant.name, &read);
  for (const Read& read : all) check_distances(all, by_name, read);
  std::vector<VariantSpec> variants;
  for (Read& read : all) variants.push_back(std::move(read.variant));
  return variants;
}

}  // namespace plumb
