#include "engine/base/document_sum.h"

#include <gtest/gtest.h>

#include <limits>

#include "engine/base/errors.h"

namespace plumb {
namespace document_sum_test {

using Json = nlohmann::ordered_json;

Json document() {
  return {{"kind", "sweep"},
          {"values", {0.1, 1e-300, -0.0, 1.0, std::numeric_limits<double>::infinity()}},
          {"count", 3},
          {"name",
           "Gr\xc3\xb6\xc3\x9f"
           "e \xff"},
          {"inner", {{"b", nullptr}, {"a", true}}}};
}

TEST(DocumentSum, FitsWhatWasWrittenInWhateverFormItIsReadAndWrittenAgain) {
  for (const int indent : {-1, 0, 4}) {
    const std::string text = to_summed_text(document(), indent);
    EXPECT_EQ(sum_in(nlohmann::json::parse(text)), DocumentSum::right) << text;
    EXPECT_EQ(sum_in(nlohmann::json::parse(nlohmann::json::parse(text).dump(7))), DocumentSum::right)
        << "sorted, with other white space";
    EXPECT_EQ(to_summed_text(Json::parse(text), indent), text) << "summed again";
  }
}

TEST(DocumentSum, DoesNotFitWhereAnyOfItChanged) {
  const Json whole = Json::parse(to_summed_text(document(), -1));
  ASSERT_EQ(sum_in(whole), DocumentSum::right);
  const auto changed = [&](auto change) {
    Json other = whole;
    change(other);
    return sum_in(other);
  };
  EXPECT_EQ(changed([](Json& json) { json["count"] = 4; }), DocumentSum::wrong);
  EXPECT_EQ(changed([](Json& json) { json["values"][0] = 0.1000000001; }), DocumentSum::wrong);
  EXPECT_EQ(changed([](Json& json) { json["inner"]["a"] = false; }), DocumentSum::wrong);
  EXPECT_EQ(changed([](Json& json) { json["inner"].erase("b"); }), DocumentSum::wrong);
  EXPECT_EQ(changed([](Json& json) { json["more"] = 1; }), DocumentSum::wrong);
  EXPECT_EQ(changed([](Json& json) { json["check_sum"] = 1; }), DocumentSum::wrong);
  EXPECT_EQ(changed([](Json& json) { json["check_sum"] = nullptr; }), DocumentSum::wrong);
  EXPECT_EQ(changed([](Json& json) { json.erase("check_sum"); }), DocumentSum::none);
}

TEST(DocumentSum, OfAChangedDocumentIsRefusedInOneLineThatNamesTheFile) {
  const auto refusal = [](const nlohmann::json& json, bool must) -> std::string {
    try {
      refuse_changed(json, "a/study.json", must);
      return "";
    } catch (const InputError& error) {
      return error.what();
    }
  };
  nlohmann::json json = nlohmann::json::parse(to_summed_text(document(), -1));
  EXPECT_EQ(refusal(json, true), "");
  json["count"] = 4;
  for (const bool must : {true, false}) {
    const std::string why = refusal(json, must);
    EXPECT_TRUE(why.starts_with("a/study.json: cannot be used: it was changed after it was written")) << why;
    EXPECT_EQ(why.find('\n'), std::string::npos) << why;
  }
  json.erase("check_sum");
  EXPECT_EQ(refusal(json, false), "");
  EXPECT_NE(refusal(json, true).find("has no check_sum"), std::string::npos) << refusal(json, true);
  EXPECT_NE(refusal(nlohmann::json::array(), true), "");
}

}  // namespace document_sum_test
}  // namespace plumb
