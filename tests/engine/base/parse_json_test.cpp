#include "engine/base/parse_json.h"

#include <gtest/gtest.h>

#include "engine/base/errors.h"

namespace plumb {
namespace parse_json_test {

using Json = nlohmann::ordered_json;

std::string refusal(const std::string& text) {
  try {
    parse_json<Json>(text, "a.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

std::string nested(int levels, const std::string& open, const std::string& close) {
  std::string text;
  for (int k = 0; k < levels; ++k) text += open;
  text += "1";
  for (int k = 0; k < levels; ++k) text += close;
  return text;
}

TEST(ParseJson, ReadsWhatIsJson) {
  EXPECT_EQ(parse_json<Json>(R"({"a":[1,{"b":null}]})", "a.json").dump(), R"({"a":[1,{"b":null}]})");
  EXPECT_EQ(refusal(nested(most_json_depth, "[", "]")), "none");
}

TEST(ParseJson, RefusesDepthBeforeTheStackEnds) {
  const std::string why = "a.json: JSON of more than 64 levels is not read";
  EXPECT_EQ(refusal(nested(most_json_depth + 1, "[", "]")), why);
  EXPECT_EQ(refusal(nested(3'000'000, "[", "]")), why);
  EXPECT_EQ(refusal(nested(1'000'000, "{\"a\":", "}")), why);
  EXPECT_EQ(refusal(std::string(3'000'000, '[')), why) << "never closed";
  EXPECT_EQ(refusal(nested(200, "[\"]]]\\\"[\",", "]")), why) << "brackets within texts close nothing";
}

TEST(ParseJson, SaysWhereItEndsAndNothingOfWhatIsThere) {
  EXPECT_EQ(refusal("root:x:0:0:secret\n"), "a.json:1:1: is not JSON");
  EXPECT_EQ(refusal("{\n \"\u00e9\": secret\n}"), "a.json:2:7: is not JSON");
  EXPECT_EQ(refusal(""), "a.json:1:1: is not JSON");
  EXPECT_EQ(refusal("[1,\n"), "a.json:2:1: is not JSON");
  EXPECT_EQ(refusal("\"\xff\""), "a.json:1:2: is not JSON");
  EXPECT_EQ(refusal("[1e999]"), "a.json: a number is larger than any that can be stored");
}

TEST(ParseJson, FaultsAreInWordsOfOurOwn) {
  const auto fault = [](auto read) -> std::string {
    try {
      read(Json::parse(R"({"a":"x","b":[1]})"));
    } catch (const nlohmann::json::exception& error) {
      return json_fault(error);
    }
    return "none";
  };
  EXPECT_EQ(fault([](const Json& json) { json.at("title"); }), "the key 'title' is missing");
  EXPECT_EQ(fault([](const Json& json) { json.at("a").get<double>(); }),
            "a value has another type than it must have");
  EXPECT_EQ(fault([](const Json& json) { json.at("a").at("b"); }),
            "a value has another type than it must have");
  EXPECT_EQ(fault([](const Json& json) { json.at("b").at(1); }), "a list is shorter than it must be");
}

TEST(ParseJson, WhatAReaderThrowsBecomesOneError) {
  const auto refused = [](auto raise) -> std::string {
    try {
      try {
        raise();
      } catch (...) {
        refuse_unusable("a.json");
      }
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  };
  EXPECT_EQ(refused([] { throw InputError("as it is"); }), "as it is");
  EXPECT_EQ(refused([] { throw std::runtime_error("it is no study"); }),
            "a.json: cannot be used: it is no study");
  EXPECT_EQ(refused([] { std::vector<int>().at(1); }),
            "a.json: cannot be used: its values do not fit together");
  EXPECT_EQ(refused([] { throw std::bad_alloc(); }),
            "a.json: cannot be used: it is too large for the memory at hand");
  EXPECT_EQ(refused([] { Json::object().at("a"); }), "a.json: cannot be used: the key 'a' is missing");
  EXPECT_THROW(refused([] { throw Interrupted(); }), Interrupted);
}

}  // namespace parse_json_test
}  // namespace plumb
