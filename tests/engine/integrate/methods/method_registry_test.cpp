#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "engine/integrate/linear_stability.h"
#include "engine/integrate/method_roles.h"

namespace plumb {
namespace method_registry_test {

const MethodParameter* parameter(const MethodInfo& info, const std::string& name) {
  for (const MethodParameter& each : info.parameters)
    if (each.name == name) return &each;
  return nullptr;
}

TEST(MethodRoles, AreFilledByMethodsThatCanDoWhatIsAskedOfThem) {
  EXPECT_EQ(usual_explicit().order, "2");
  EXPECT_TRUE(usual_explicit().takes_step && !usual_explicit().implicit) << usual_explicit().name;
  EXPECT_TRUE(classical_explicit().takes_step && !classical_explicit().implicit) << classical_explicit().name;
  EXPECT_TRUE(accurate_explicit().takes_step && accurate_explicit().takes_tolerances);
  EXPECT_FALSE(accurate_explicit().implicit) << accurate_explicit().name;
  EXPECT_TRUE(embedded_explicit().takes_tolerances && !embedded_explicit().implicit);
  EXPECT_NE(embedded_explicit().name, accurate_explicit().name) << "two unlike methods certify a reference";
  const MethodParameter* order = parameter(embedded_explicit(), "order");
  ASSERT_NE(order, nullptr) << embedded_explicit().name;
  EXPECT_TRUE(order->minimum <= 5 && order->maximum >= 8) << order->minimum << " to " << order->maximum;
  for (const MethodInfo* implicit : {&usual_implicit(), &accurate_implicit()}) {
    EXPECT_TRUE(implicit->takes_step && implicit->implicit) << implicit->name;
    EXPECT_TRUE(std::isinf(*stability_limit(plain_method(*implicit)))) << implicit->name;
  }
  EXPECT_FALSE(usual_implicit().damps_with.empty());
  EXPECT_LT(*amplification(plain_method(usual_implicit()), 1e3), 1);
  EXPECT_TRUE(energy_keeping().keeps_energy) << energy_keeping().name;
  EXPECT_TRUE(rigid_rod_method().takes_step) << rigid_rod_method().name;
  for (const std::string& name : few_unlike_methods()) EXPECT_NE(find_method(name), nullptr) << name;
}

TEST(Methods, AreNamedByNothingButTheirOwnFilesAndTheRegistry) {
  namespace fs = std::filesystem;
  const fs::path source = PLUMB_SOURCE_DIR;
  int looked_at = 0;
  for (const char* top : {"engine", "render", "report"})
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(source / top)) {
      const fs::path extension = entry.path().extension(), folder = entry.path().parent_path();
      if (extension != ".cpp" && extension != ".h") continue;
      if (folder == source / "engine/integrate/methods" || folder == source / "engine/integrate/sundials")
        continue;
      ++looked_at;
      std::stringstream text;
      text << std::ifstream(entry.path()).rdbuf();
      for (const MethodInfo& info : method_infos())
        EXPECT_EQ(text.str().find('"' + info.name + '"'), std::string::npos)
            << entry.path() << " names " << info.name;
    }
  EXPECT_GT(looked_at, 100);
}

TEST(Methods, VaryParametersOfTheirOwnWithinTheirRanges) {
  for (const MethodInfo& info : method_infos()) {
    if (info.varied.values.empty()) continue;
    const MethodParameter* varied = parameter(info, info.varied.name);
    ASSERT_NE(varied, nullptr) << info.name << " has no " << info.varied.name;
    for (const double value : info.varied.values) {
      EXPECT_GE(value, varied->minimum) << info.name;
      EXPECT_LE(value, varied->maximum) << info.name;
    }
  }
}

}  // namespace method_registry_test
}  // namespace plumb
