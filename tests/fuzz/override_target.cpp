#include "engine/read/override.h"
#include "engine/read/value_text.h"
#include "tests/fuzz/small_files.h"

namespace plumb::fuzz {
namespace {

/// Whether two values say the same, wherever they stand.
bool alike(const TomlValue& a, const TomlValue& b) {
  const bool same = a.kind == b.kind && a.string == b.string && a.boolean == b.boolean &&
                    (a.number == b.number || (std::isnan(a.number) && std::isnan(b.number))) &&
                    a.items.size() == b.items.size();
  if (!same) return false;
  for (std::size_t k = 0; k < a.items.size(); ++k)
    if (a.items[k].key != b.items[k].key || !alike(a.items[k], b.items[k])) return false;
  return true;
}

bool has_date(const TomlValue& value) {
  return value.kind == TomlValue::Kind::date || std::any_of(value.items.begin(), value.items.end(), has_date);
}

/// A line an override.
bool feed(std::string_view input) {
  std::vector<std::string> overrides;
  for (std::size_t from = 0; from <= input.size() && overrides.size() < 20;) {
    const std::size_t end = std::min(input.find('\n', from), input.size());
    overrides.emplace_back(input.substr(from, end - from));
    from = end + 1;
  }
  CaseSource source = small_source();
  source.overrides = overrides;
  return reads<InputError, UsageError>([&] {
    TomlValue root;
    for (const std::string& text : overrides) apply_override(root, text);
    // Written as a line and read again, a value is the same.
    for (const TomlValue& item : root.items) {
      if (has_date(item)) continue;
      TomlValue again;
      apply_override(again, "again=" + value_text(item));
      promise(alike(again.items.at(0), item), "a value changes as it is written: " + value_text(item));
    }
    load_case(source);
  });
}

std::vector<std::string> seeds() {
  return {"cable.elements=8",
          "title=bare words\nloads.gravity=[0, -9.81, 0]",
          "loads.gravity.1=-9.8",
          "probe.0.at=\"1/4\"\nmethod.step=2e-3",
          "scene.camera={eye=[0,0,5],target=[0,0,0]}",
          "reference.0.tolerance=0.5\nparameters.f=6"};
}

}  // namespace

const Target override_target{"override", feed, seeds};

}  // namespace plumb::fuzz
