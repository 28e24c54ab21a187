#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/nearest.h"
#include "engine/case/distribution_words.h"
#include "engine/read/case_sections.h"
#include "engine/read/uncertain_keys.h"

namespace plumb {
namespace {

UncertainInput read_input(TableReader& table, const Case& spec, const std::vector<UncertainInput>& others) {
  UncertainInput input;
  input.key = table.text("key", "the key of an uncertain number, as --set takes it");
  input.distribution = table.choice<Distribution>("distribution", Distribution::normal);
  input.relative = table.flag("relative", false);
  input.spread =
      table.number("spread", Range::positive(input.relative ? "a share of the value" : "the key's own unit"));
  input.source = table.prose("source", "where the spread is from");
  table.finish();

  const std::vector<std::string> known = uncertain_keys(spec);
  if (std::find(known.begin(), known.end(), input.key) == known.end())
    table.refuse_value("key",
                       "is no number of the case that can be uncertain" + suggestion(input.key, known));
  const auto same = [&](const UncertainInput& other) { return other.key == input.key; };
  if (std::any_of(others.begin(), others.end(), same))
    table.refuse_value("key", "is the key of another input");
  if (input.relative && *uncertain_value(spec, input.key) == 0)
    table.refuse_value("relative", fmt::format("{} is 0, which has no share", input.key));
  return input;
}

}  // namespace

UncertaintySpec read_uncertainty(TableReader table, const Case& spec) {
  constexpr int most_samples = 10000;
  UncertaintySpec read;
  read.numerical = table.flag("numerical", true);
  read.samples = table.whole("samples", 0, most_samples, 0);
  read.seed = static_cast<long>(table.number("seed", Range::seed(), static_cast<double>(read.seed)));
  std::vector<TableReader> inputs = table.tables("input");
  table.finish();

  for (TableReader& input : inputs) read.inputs.push_back(read_input(input, spec, read.inputs));
  if (read.samples == 1) table.refuse_value("samples", "must be 0 or at least 2: one sample has no spread");
  if (read.samples > 0 && read.inputs.empty())
    table.refuse_value("samples", "needs an [[uncertainty.input]] to sample");
  return read;
}

}  // namespace plumb
