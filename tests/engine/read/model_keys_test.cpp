#include <gtest/gtest.h>

#include "tests/engine/small_case.h"

namespace plumb {
namespace model_keys_test {

CaseSource small_with(const std::string& from, const std::string& to) {
  CaseSource source = small_case();
  source.file.text = with(source.file.text, from, to);
  return source;
}

TEST(ModelKeys, AForceOnTheLastEndIsRead) {
  EXPECT_EQ(load_case(small_case()).spec.loads.end_force, Vec3(0, 0, 0));
  EXPECT_EQ(load_case(small_with("[loads]", "[loads]\nend_force = [1, \"2 * f\", -3]")).spec.loads.end_force,
            Vec3(1, 10, -3));
}

TEST(ModelKeys, AForceThatIsNotThreeNumbersIsRefused) {
  EXPECT_TRUE(
      matches(refusal(small_with("[loads]", "[loads]\nend_force = [1, 2]")),
              "case.toml:22:13: loads.end_force = [1, 2]: must be a list of 3 numbers (N), found 2 of them"))
      << refusal(small_with("[loads]", "[loads]\nend_force = [1, 2]"));
}

TEST(ModelKeys, AnAxialSpeedIsRead) {
  EXPECT_EQ(load_case(small_case()).spec.start.axial_speed, 0);
  EXPECT_EQ(load_case(small_with("[start]", "[start]\naxial_speed = \"-f/2\"")).spec.start.axial_speed, -2.5);
}

TEST(ModelKeys, AnAxialSpeedThatIsNotANumberIsRefused) {
  const std::string message = refusal(small_with("[start]", "[start]\naxial_speed = true"));
  EXPECT_TRUE(
      matches(message, "case.toml:15:15: start.axial_speed = true: must be a number (m/s), found a boolean"))
      << message;
}

CaseSource small_chain() {
  CaseSource source = small_with("quadrature = \"full\"\n", "model = \"chain\"\n");
  source.file.text = with(source.file.text, "second_moment = 5e-11\n", "");
  return source;
}

TEST(ModelKeys, AChainIsReadAndDoesNotBend) {
  EXPECT_EQ(load_case(small_case()).spec.cable.model, CableModel::cable);
  const Case spec = load_case(small_chain()).spec;
  EXPECT_EQ(spec.cable.model, CableModel::chain);
  EXPECT_EQ(spec.cable.second_moment, 0);
}

TEST(ModelKeys, AnUnknownModelIsRefused) {
  const std::string message = refusal(small_with("elements = 4", "elements = 4\nmodel = \"chian\""));
  EXPECT_TRUE(matches(message, "case.toml:12:9: cable.model = \"chian\": …did you mean \"chain\"?"))
      << message;
}

TEST(ModelKeys, KeysOfBendingAreRefusedForAChain) {
  for (const auto& [key, place] :
       {std::pair{"second_moment = 0", "case.toml:11:17: cable.second_moment = 0"},
        {"quadrature = \"full\"", "case.toml:11:14: cable.quadrature = \"full\""}}) {
    CaseSource source = small_chain();
    source.file.text = with(source.file.text, "elements = 4", std::string("elements = 4\n") + key);
    EXPECT_EQ(refusal(source), std::string(place) + ": not a key of a chain, whose links only stretch");
  }
}

TEST(ModelKeys, AClampedEndIsRefusedForAChain) {
  for (const auto& [from, to, place] :
       {std::tuple{"first = \"pinned\"", "first = \"clamped\"", "case.toml:18:9: supports.first"},
        {"last = \"free\"", "last = \"clamped\"", "case.toml:19:8: supports.last"}}) {
    CaseSource source = small_chain();
    source.file.text = with(source.file.text, from, to);
    EXPECT_EQ(refusal(source),
              std::string(place) +
                  " = \"clamped\": a chain does not bend, so that its ends can be free or pinned "
                  "only");
  }
}

TEST(ModelKeys, StaticsRefusesAStartThatMoves) {
  CaseSource source = small_case();
  source.overrides = {"method.name=statics"};
  EXPECT_EQ(
      refusal(source),
      "case.toml:16:20: start.angular_velocity = [0, 4, 0]: must be 0 for statics, which starts at rest");
  source.overrides.push_back("start.angular_velocity=[0, 0, 0]");
  EXPECT_EQ(refusal(source), "accepted");
  source.overrides.push_back("start.axial_speed=2");
  const std::string message = refusal(source);
  EXPECT_TRUE(matches(message, "--set start.axial_speed=2: must be 0 for statics, which starts at rest"))
      << message;
}

TEST(ModelKeys, StaticsFollowsOneOfTwoPaths) {
  CaseSource source = small_case();
  source.overrides = {"method.name=statics", "start.angular_velocity=[0, 0, 0]"};
  EXPECT_EQ(load_case(source).spec.method.parameters.at("follow"), 0);
  source.overrides.emplace_back("method.follow=primary");
  EXPECT_EQ(load_case(source).spec.method.parameters.at("follow"), 1);
  source.overrides.back() = "method.follow=secondary";
  const std::string message = refusal(source);
  EXPECT_TRUE(matches(message, "--set method.follow=secondary: must be \"stable\" or \"primary\""))
      << message;
  source.overrides = {"method.follow=stable"};
  EXPECT_NE(refusal(source).find("it belongs to statics"), std::string::npos) << refusal(source);
}

TEST(ModelKeys, AnImperfectionIsSmallAndHasABucklingModeToBeIn) {
  CaseSource source = small_case();
  const auto with = [&](const std::vector<std::string>& overrides) {
    source.overrides = {"supports.first=clamped", "loads.gravity=[-9.81, 0, 0]", "start.direction=[1, 0, 0]"};
    source.overrides.insert(source.overrides.end(), overrides.begin(), overrides.end());
    return refusal(source);
  };
  EXPECT_EQ(with({"start.imperfection=1e-3"}), "accepted");
  EXPECT_EQ(load_case(source).spec.start.imperfection, 1e-3);
  EXPECT_EQ(with({"start.imperfection=-1e-3"}), "accepted");
  EXPECT_NE(with({"start.imperfection=0.5"}).find("must be at most a tenth of the length"), std::string::npos)
      << with({"start.imperfection=0.5"});
  for (const char* load :
       {"loads.gravity=[9.81, 0, 0]", "loads.gravity=[0, -9.81, 0]", "loads.gravity=[0, 0, 0]"}) {
    const std::string message = with({"start.imperfection=1e-3", load});
    EXPECT_NE(message.find("start.imperfection"), message.npos) << load << ": " << message;
    EXPECT_NE(message.find("there is no buckling mode"), message.npos) << load << ": " << message;
  }
  const std::string chain = with({"start.imperfection=1e-3", "supports.first=pinned", "cable.model=chain"});
  EXPECT_NE(chain.find("must be 0 for the model chain"), chain.npos) << chain;
}

}  // namespace model_keys_test
}  // namespace plumb
