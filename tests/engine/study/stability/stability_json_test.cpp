#include "engine/study/stability/stability_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "engine/base/errors.h"
#include "engine/study/stability/stability_file.h"
#include "tests/engine/study/changed_json.h"
#include "tests/engine/study/stability/tiny_stability.h"

namespace plumb {
namespace stability_file_test {

/// A study of anything, whole but without sense.
class RandomStability {
 public:
  explicit RandomStability(unsigned seed) : random_(seed) {}

  Stability make() {
    Stability study;
    study.title = text();
    study.parameter = text();
    study.parameter_value = number();
    study.elements = whole();
    study.end = number();
    study.duration = number();
    study.tolerance = number();
    for (int k = whole() % 4; k > 0; --k) study.maps.push_back(map());
    for (int k = whole() % 4; k > 0; --k)
      study.critical_steps.push_back({text(),
                                      method(),
                                      number(),
                                      whole(),
                                      number(),
                                      number(),
                                      outcome(),
                                      LimitKind::contraction,
                                      {number(), number()}});
    for (int k = whole() % 4; k > 0; --k)
      study.energies.push_back({text(), number(), number(), outcome(), text(), {1, 2}, {number(), number()}});
    for (int k = whole() % 4; k > 0; --k)
      study.amplifications.push_back({text(), number(), number(), number()});
    for (int k = whole() % 4; k > 0; --k)
      study.divergences.push_back(
          {number(), whole(), {number()}, {number()}, number(), number(), whole() % 2 == 0, text()});
    for (int k = whole() % 4; k > 0; --k)
      study.references.push_back(
          {number(), whole(), number(), text(), text(), number(), number(), number(), number()});
    for (int k = whole() % 4; k > 0; --k)
      study.statistics.push_back({text(), number(), number(), outcome(), text(), number(), whole() % 2 == 0,
                                  number(), number(), number(), number()});
    study.provenance = {{text(), text()}};
    return study;
  }

 private:
  int whole() { return static_cast<int>(random_() % 1000); }
  double number() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    switch (random_() % 8) {
      case 0:
        return infinity;
      case 1:
        return -infinity;
      case 2:
        return -1;
      default:
        return std::ldexp(static_cast<double>(random_()) - 2e9, static_cast<int>(random_() % 200) - 100);
    }
  }
  std::string text() {
    static const std::vector<std::string> parts{"a", "\"", "\\", "ρ∞", " ", "</script>", "é", "0.5"};
    std::string result;
    for (int k = whole() % 6; k > 0; --k) result += parts[random_() % parts.size()];
    return result;
  }
  Outcome outcome() { return outcomes()[random_() % outcomes().size()]; }
  MethodSpec method() {
    MethodSpec spec{text(), {}, {}, {}, {{text(), 0.1}}};
    if (whole() % 2 == 0) spec.step = 0.1;
    if (whole() % 2 == 0) spec.rtol = spec.atol = 0.3;
    return spec;
  }
  OutcomeMap map() {
    OutcomeMap map;
    map.label = text();
    map.method = method();
    map.by_step = whole() % 2 == 0;
    map.axis = std::vector{MapAxis::parameter, MapAxis::elements, MapAxis::duration}[random_() % 3];
    map.settings = {0.1, 0.2, 0.7};
    map.values = {-1, 3};
    map.limit_kind = LimitKind::vibration;
    map.limits = {{number(), number()}, {number(), number()}};
    map.in_words = text();
    for (int k = 0; k < 6; ++k)
      map.points.push_back({outcome(), text(), number(), number(), number(), number(), whole(), number()});
    return map;
  }

  std::mt19937 random_;
};

std::string refusal_of(const std::string& text) {
  try {
    decode_stability(text, "study.json");
    return "accepted";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(StabilityFile, WhatIsWrittenIsRead) {
  const LoadedCase loaded = tiny_stability_case();
  for (unsigned seed = 0; seed < 200; ++seed) {
    const StabilityStudyFile study{loaded, RandomStability(seed).make()};
    const StabilityStudyFile back = decode_stability(encode_stability(study), "study.json");
    EXPECT_EQ(stability_to_json(back.result).dump(1), stability_to_json(study.result).dump(1)) << seed;
    EXPECT_EQ(back.loaded.spec, loaded.spec);
    ASSERT_EQ(back.result.maps.size(), study.result.maps.size());
    for (std::size_t k = 0; k < study.result.maps.size(); ++k) {
      EXPECT_EQ(back.result.maps[k].method, study.result.maps[k].method);
      EXPECT_EQ(back.result.maps[k].points[3].energy_change, study.result.maps[k].points[3].energy_change);
    }
  }
}

TEST(StabilityFile, KeepsAStudyThatWasMade) {
  const StabilityStudyFile back = decode_stability(encode_stability(tiny_stability()), "study.json");
  EXPECT_EQ(stability_to_json(back.result).dump(), stability_to_json(tiny_stability().result).dump());
  EXPECT_EQ(back.loaded.source.file.text, tiny_stability().loaded.source.file.text);
}

TEST(StabilityFile, NotANumberIsKept) {
  Stability study;
  study.parameter_value = std::nan("");
  EXPECT_TRUE(std::isnan(stability_from_json(stability_to_json(study)).parameter_value));
}

TEST(StabilityFile, CutAnywhereIsRefused) {
  const std::string whole = encode_stability(tiny_stability());
  for (const double share : {0.0, 0.1, 0.5, 0.9, 0.9999}) {
    const auto kept = static_cast<std::size_t>(share * static_cast<double>(whole.size()));
    const std::string message = refusal_of(whole.substr(0, kept));
    EXPECT_TRUE(message.starts_with("study.json:1:") && message.ends_with(": is not JSON")) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
  EXPECT_EQ(refusal_of(whole), "accepted");
}

TEST(StabilityFile, AnyValueThatWasChangedIsReadOrRefusedInWords) {
  using Json = nlohmann::ordered_json;
  expect_changes_read_or_refused(Json::parse(encode_stability(tiny_stability())), 50,
                                 [](const Json& changed) {
                                   const std::string why = refusal_of(changed.dump());
                                   return why == "accepted" ? "" : why;
                                 });
}

TEST(StabilityFile, WhatDoesNotFitTogetherIsRefused) {
  using Json = nlohmann::ordered_json;
  const Json good = Json::parse(encode_stability(tiny_stability()));
  const std::vector<std::pair<std::string, Json>> changes{
      {"/kind", "sweep"},
      {"/version", 2},
      {"/version", "1"},
      {"/case/file/text", "title = 3"},
      {"/case/overrides", Json::array({"nonsense"})},
      {"/result", Json::array()},
      {"/result/title", 3},
      {"/result/elements", 1.5},
      {"/result/end", "much"},
      {"/result/end", nullptr},
      {"/result/maps", 1},
      {"/result/maps/0/axis", "sideways"},
      {"/result/maps/0/limit_kind", "sometimes"},
      {"/result/maps/0/settings", Json::array({2, 1})},
      {"/result/maps/0/settings", Json::array()},
      {"/result/maps/0/settings/0", -1},
      {"/result/maps/0/values/0", "nan"},
      {"/result/maps/0/points", Json::array()},
      {"/result/maps/0/points/0/outcome", "splendid"},
      {"/result/maps/0/limits", Json::array({Json::object({{"at_start", 1}, {"at_worst", 1}})})},
      {"/result/maps/0/method", Json::object()},
      {"/result/energies/0/times", Json::array({1})},
      {"/result/separations/0/distances", Json::array({1})},
  };
  for (const auto& [where, value] : changes) {
    Json bad = good;
    bad[Json::json_pointer(where)] = value;
    const std::string message = refusal_of(bad.dump());
    EXPECT_NE(message.find("study.json: "), std::string::npos) << where << ": " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
  for (const char* key : {"maps", "title", "references", "provenance"}) {
    Json bad = good;
    bad["result"].erase(key);
    EXPECT_NE(refusal_of(bad.dump()).find("study.json: cannot be used"), std::string::npos) << key;
  }
}

}  // namespace stability_file_test
}  // namespace plumb
