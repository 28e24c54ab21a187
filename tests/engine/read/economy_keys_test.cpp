#include <gtest/gtest.h>

#include "engine/study/economy/run_economy.h"
#include "tests/engine/small_case.h"

namespace plumb {
namespace economy_keys_test {

CaseSource with_economy(const std::string& lines) {
  CaseSource source = small_case();
  source.file.text += "[study.economy]\n" + lines;
  return source;
}

TEST(EconomyKeys, TheToleranceOfAScene) {
  EXPECT_EQ(load_case(small_case()).spec.scene.tolerance, 0.5);
  CaseSource source = small_case();
  source.overrides = {"scene.tolerance=\"f/4\""};
  EXPECT_EQ(load_case(source).spec.scene.tolerance, 1.25);
  for (const char* bad : {"0", "-1", "inf", "nan"}) {
    source.overrides = {std::string("scene.tolerance=") + bad};
    EXPECT_NE(refusal(source).find("number greater than 0 (pixels)"), std::string::npos) << refusal(source);
  }
  source.overrides = {"scene.size=[64,48]", "scene.tolerance=65"};
  EXPECT_NE(refusal(source).find("must be at most as many pixels as the picture has, 64"), std::string::npos)
      << "nothing is further off: " << refusal(source);
}

TEST(EconomyKeys, AMethodMayBeLeftToTheScene) {
  CaseSource source = small_case();
  const std::string text = source.file.text;
  const std::size_t begin = text.find("[method]"), end = text.find('[', begin + 1);
  source.file.text = text.substr(0, begin) + "[method]\nname = \"scene\"\n\n" + text.substr(end);
  EXPECT_EQ(load_case(source).spec.method.name, scene_method);
  source.file.text = with(source.file.text, "name = \"scene\"", "name = \"scene\"\nstep = 1e-3");
  EXPECT_NE(refusal(source).find("method.step = 1e-3: not a key of \"scene\", which chooses"),
            std::string::npos)
      << refusal(source);
}

TEST(EconomyKeys, AnEmptyTableGivesTheDefaultsThatACaseWithoutOneHas) {
  const Case without = load_case(small_case()).spec;
  EXPECT_FALSE(without.economy.has_value());
  EXPECT_EQ(load_case(with_economy("")).spec.economy, economy_study_of(without));
  EXPECT_EQ(economy_study_of(without).widths, std::vector<int>{without.scene.size[0]});
}

TEST(EconomyKeys, EveryKeyIsRead) {
  const EconomySpec spec =
      *load_case(with_economy("widths = [960, 160, 160]\nscenes = \"20 * f\"\nseed = 12\n"
                              "reference_elements = 32\n[study.economy.close_up]\n"
                              "eye = [1, 2, 3]\ntarget = [0, 0, 0]\nview_height = 0.5\n"))
           .spec.economy;
  EXPECT_EQ(spec.widths, (std::vector<int>{160, 960}));
  EXPECT_EQ(spec.scenes, 100);
  EXPECT_EQ(spec.seed, 12);
  EXPECT_EQ(spec.reference_elements, 32);
  ASSERT_TRUE(spec.close_up.has_value());
  EXPECT_EQ(spec.close_up->view_height, 0.5);
}

TEST(EconomyKeys, BadValuesAreRefusedWithWhatIsAllowed) {
  for (const auto& [lines, says] : std::vector<std::pair<std::string, std::string>>{
           {"widths = [8]", "widths.0 = 8: must be a whole number from 16 to 32768"},
           {"widths = [16]", "widths = [16]: gives a picture of 16 by 12 pixels"},
           {"scenes = -1", "scenes = -1: must be a whole number from 0 to 100000"},
           {"scenes = 100001", "scenes = 100001: must be a whole number from 0 to 100000"},
           {"seed = -1", "seed = -1: must be a whole number from 0 to 1000000000000000"},
           {"reference_elements = 1", "reference_elements = 1: must be a whole number from 2 to 4096"},
           {"close_up = { eye = [1, 1, 1], target = [1, 1, 1] }", "must be somewhere else than eye"},
           {"width = [160]", "width = [160]: unknown key; did you mean \"widths\"?"},
       }) {
    const std::string message = refusal(with_economy(lines));
    EXPECT_NE(message.find("case.toml:71:"), std::string::npos) << message;
    EXPECT_NE(message.find(says), std::string::npos) << message << "\n" << says;
  }
}

}  // namespace economy_keys_test
}  // namespace plumb
