#include "engine/study/reference/certified_reference.h"

#include <gtest/gtest.h>

#include "tests/engine/pendulum.h"

namespace plumb {
namespace study_reference_test {

Case short_pendulum() {
  Case spec = pendulum(5, 2);
  spec.time = {0.1, 0.02};
  return spec;
}

TEST(StudyReference, TwoMethodsOfHighOrderAgreeToTheTarget) {
  const StudyReference reference = make_reference(short_pendulum(), 1e-11, 10);
  EXPECT_GE(reference.certificate.agreement, 0);
  EXPECT_LE(reference.certificate.agreement, 1e-11) << reference.certificate.second;
  EXPECT_EQ(reference.trajectory.times.size(), 6U);
  EXPECT_EQ(reference.certificate.elements, 2);
  const Trajectory again = run(short_pendulum(), method("rk4", 1e-5), {0.1, 0.02});
  EXPECT_LT(tip_distance(again, reference.trajectory), 1e-10);
}

TEST(StudyReference, ABadPairIsNotCertifiedAndItsFloorIsDrawn) {
  StudyReference reference =
      hold_together(short_pendulum(), method("arkode-erk", {}, 1e-10), method("generalized-alpha", 1e-3), 10);
  CertifiedReference& certificate = reference.certificate;
  ASSERT_GT(certificate.agreement, 1e-6) << "the second is of low order and coarse";
  certify(certificate, 1e-6);
  EXPECT_FALSE(certificate.certified);
  EXPECT_DOUBLE_EQ(certificate.floor, 10 * certificate.agreement);
  EXPECT_NE(certificate.why_not.find("ten times better"), std::string::npos) << certificate.why_not;
  certify(certificate, 11 * certificate.agreement);
  EXPECT_TRUE(certificate.certified) << certificate.why_not;
  EXPECT_EQ(certificate.why_not, "");
}

TEST(StudyReference, OneThatFailedOrRanOutOfTimeIsNotCertified) {
  for (StudyReference reference :
       {hold_together(short_pendulum(), method("arkode-erk", {}, 1e-8), method("rk4", 0.02), 10),
        make_reference(short_pendulum(), 1e-11, 0)}) {
    EXPECT_EQ(reference.certificate.agreement, -1);
    certify(reference.certificate, 1e-3);
    EXPECT_FALSE(reference.certificate.certified);
    EXPECT_EQ(reference.certificate.why_not, "no two methods completed the reference");
  }
}

TEST(StudyReference, TheErrorOfItsMeshIsPartOfTheJudgement) {
  CertifiedReference reference;
  reference.agreement = 1e-10;
  certify(reference, 1e-6, 1e-5);
  EXPECT_FALSE(reference.certified);
  EXPECT_EQ(reference.floor, 1e-5);
  EXPECT_NE(reference.why_not.find("mesh"), std::string::npos);
  certify(reference, 1e-4, 1e-5);
  EXPECT_TRUE(reference.certified);
  certify(reference, 1e-4, -1);
  EXPECT_FALSE(reference.certified) << "an unknown mesh error certifies nothing";
}

}  // namespace study_reference_test
}  // namespace plumb
