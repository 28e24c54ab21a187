#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>

namespace plumb {

/// Calls `act` with every value within another, and then with that one.
inline void for_each_value(nlohmann::ordered_json& json,
                           const std::function<void(nlohmann::ordered_json&)>& act) {
  if (json.is_structured())
    for (auto& part : json) for_each_value(part, act);
  act(json);
}

/// Reads a document with some `most` of its values, one at a time, replaced by one of another kind or taken
/// away: each must be read or refused in one line of our own words. `read` returns the refusal, or "".
inline void expect_changes_read_or_refused(
    nlohmann::ordered_json document, std::size_t most,
    const std::function<std::string(const nlohmann::ordered_json&)>& read) {
  using Json = nlohmann::ordered_json;
  const std::vector<Json> others{nullptr,
                                 "x",
                                 -1,
                                 1e300,
                                 Json::array(),
                                 Json::object(),
                                 true,
                                 Json::array({nullptr}),
                                 std::uint64_t{18446744073709551615U}};
  const auto try_it = [&](const std::string& what) {
    const std::string why = read(document);
    EXPECT_EQ(why.find("exception"), std::string::npos) << what << ": " << why;
    EXPECT_EQ(why.find('\n'), std::string::npos) << what << ": " << why;
    return !why.empty();
  };
  std::size_t values = 0, place = 0, tried = 0, refused = 0;
  for_each_value(document, [&](Json&) { ++values; });
  const std::size_t step = values / most + 1;
  for_each_value(document, [&](Json& value) {
    if (place++ % step != 0) return;
    const Json before = value;
    value = others[tried++ % others.size()];
    refused += try_it(before.dump(-1, ' ', false, Json::error_handler_t::replace).substr(0, 60) + " -> " +
                      value.dump())
                   ? 1
                   : 0;
    value = before;
    if (!before.is_object() || before.empty()) return;
    const std::string key =
        std::next(before.items().begin(), static_cast<std::ptrdiff_t>(tried % before.size())).key();
    value.erase(key);
    try_it("without " + key);
    value = before;
  });
  EXPECT_GT(refused, tried / 4) << "of " << tried;
  EXPECT_EQ(read(document), "") << "as it was";
}

}  // namespace plumb
