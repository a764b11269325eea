#include "drape/form_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "base/random.h"
#include "drape/turn.h"

namespace seamwise {
namespace {

Form formOf(const char* size) {
  Outcome<Form> form = Form::make(*measuresOf(size));
  EXPECT_TRUE(form.ok());
  return std::move(form).value();
}

TEST(DrapeTurn, IsExactAtQuartersAndRightToTheLastBitsElsewhere) {
  for (int quarter = -9; quarter <= 9; ++quarter) {
    const Turn turn = turnOfDegrees(90 * quarter);
    EXPECT_EQ(turn.sine, std::nearbyint(std::sin(quarter * kPi / 2)));
    EXPECT_EQ(turn.cosine, std::nearbyint(std::cos(quarter * kPi / 2)));
  }
  for (double degrees = -400; degrees <= 400; degrees += 0.37) {
    const Turn turn = turnOfDegrees(degrees);
    EXPECT_NEAR(turn.sine, std::sin(degrees * kPi / 180), 2e-15);
    EXPECT_NEAR(turn.cosine, std::cos(degrees * kPi / 180), 2e-15);
    EXPECT_EQ(turnOfDegrees(-degrees).sine, -turn.sine);
    EXPECT_EQ(turnOfDegrees(-degrees).cosine, turn.cosine);
  }
}

TEST(DrapeTurn, FindsTheDegreesOfAFileAndOfADirection) {
  for (const double degrees : {45.0, -140.0, 45.5, 180.0, -90.0})
    EXPECT_EQ(degreesOf(degrees * kPi / 180), degrees);
  for (double degrees = -179; degrees < 180; degrees += 7) {
    const Turn turn = turnOfDegrees(degrees);
    EXPECT_NEAR(degreesBetween(turn.cosine, turn.sine), degrees, 1e-11);
  }
  EXPECT_EQ(degreesBetween(1, 0), 0);
  EXPECT_EQ(degreesBetween(-1, 0), 180);
}

TEST(DrapeForm, HasTheGirthsOfEverySize) {
  for (const Size& size : kSizes) {
    const Measures& m = size.measures;
    const Form form = Form::make(m).value();
    const auto girth = [&](BodyPart part, double level) {
      return form.tube(part).section(level).girth();
    };
    EXPECT_NEAR(girth(BodyPart::kTorso, 0.45 * m.back_length), m.bust, 1e-6) << size.name;
    EXPECT_NEAR(girth(BodyPart::kTorso, 0), m.waist, 1e-6);
    EXPECT_NEAR(girth(BodyPart::kTorso, -m.hip_depth), m.hip, 1e-6);
    EXPECT_NEAR(girth(BodyPart::kNeck, 1), m.neck, 1e-6);
    EXPECT_NEAR(girth(BodyPart::kHead, 16), m.head, 1e-6);
    for (const BodyPart arm : {BodyPart::kLeftArm, BodyPart::kRightArm}) {
      EXPECT_NEAR(girth(arm, -0.22 * m.arm_length), m.upper_arm, 1e-6);
      EXPECT_NEAR(girth(arm, -m.arm_length), m.wrist, 1e-6);
    }
    const double crotch = form.crotchHeight();
    EXPECT_NEAR(girth(BodyPart::kLeftLeg, -5), m.thigh, 1e-6);
    EXPECT_NEAR(girth(BodyPart::kLeftLeg, m.waist_height - m.knee_depth - crotch), m.knee, 1e-6);
    EXPECT_NEAR(girth(BodyPart::kRightLeg, 8 - crotch), m.ankle, 1e-6);
  }
}

// Bodies of every size, each measurement varied by up to 3 %.
std::vector<Measures> variedBodies() {
  std::vector<Measures> bodies;
  Random random(30);
  for (const Size& size : kSizes)
    for (int k = 0; k < 6; ++k) {
      Measures m = size.measures;
      for (const MeasureName& name : kMeasureNames) m.*name.value *= 0.97 + 0.06 * random.uniform();
      bodies.push_back(m);
    }
  return bodies;
}

TEST(DrapeForm, HasTheHipOfABodyWithAndWithoutLegs) {
  for (const Measures& m : variedBodies()) {
    const Form form = Form::make(m).value();
    const double hip = m.waist_height - m.hip_depth;
    EXPECT_NEAR(form.girthAround(hip, only(BodyPart::kTorso)), m.hip, 0.1);
    EXPECT_NEAR(form.girthAround(hip, only(BodyPart::kTorso) | kLegs), m.hip, 0.1);
    EXPECT_NEAR(form.girthAround(m.waist_height, only(BodyPart::kTorso) | kLegs), m.waist, 0.1);
  }
}

TEST(DrapeForm, TapersWithoutWavesBetweenItsSections) {
  const Form form = formOf("m");
  const Tube& torso = form.tube(BodyPart::kTorso);
  for (double level = -24; level < -1; level += 0.5)
    EXPECT_GT(torso.section(level).girth(), torso.section(level + 0.5).girth());
  for (double level = 1.5; level < 17; level += 0.5)
    EXPECT_LT(torso.section(level).girth(), torso.section(level + 0.5).girth());
}

TEST(DrapeForm, DistanceHasTheGradientOfItsDifferencesAndNoJumpInIt) {
  const Form form = formOf("m");
  double worst = 0, jump = 0;
  for (double x = -60; x <= 60; x += 3.7)
    for (double y = 5; y <= 175; y += 4.3)
      for (double z = -21; z <= 21; z += 3.1) {
        const Vec3 p(x, y, z);
        Vec3 gradient, beside;
        const double d = form.distance(p, &gradient);
        if (std::abs(d) > 3) continue;
        const double step = 1e-4;
        form.distance(p + Vec3(step, step, step), &beside);
        jump = std::max(jump, (beside - gradient).norm());
        for (int axis = 0; axis < 3; ++axis) {
          const Vec3 shift = step * Vec3::Unit(axis);
          const double difference =
              (form.distance(p + shift, nullptr) - form.distance(p - shift, nullptr)) / (2 * step);
          worst = std::max(worst, std::abs(difference - gradient[axis]));
        }
      }
  EXPECT_LT(worst, 1e-3);  // two one-sided slopes at a jump of the second derivative, times 1e-4
  EXPECT_LT(jump, 2e-3);
}

TEST(DrapeForm, DistanceGrowsByItsGradientWhichIsShorterInFillets) {
  const Form form = formOf("m");
  const Surface surface = surfaceOf(form, kWholeBody, 4);
  for (const Vec3& p : surface.vertices) {
    Vec3 gradient;
    EXPECT_NEAR(form.distance(p, &gradient), 0, 1e-5);
    EXPECT_LT(gradient.norm(), 1.001);
    const double d = form.distance(p + 0.1 * gradient / gradient.norm(), nullptr);
    EXPECT_NEAR(d, 0.1 * gradient.norm(), 0.01);
    EXPECT_EQ(form.distance(mirrored(p), nullptr), form.distance(p, nullptr));
  }
}

TEST(DrapeForm, SurfaceIsClosedOrientedAndSymmetric) {
  const Form form = formOf("m");
  const Surface surface = surfaceOf(form, kTorsoAndNeck | kArms, 3);
  std::map<std::pair<int, int>, int> sides;
  double volume = 0;
  for (const auto& [a, b, c] : surface.triangles) {
    ++sides[{a, b}], ++sides[{b, c}], ++sides[{c, a}];
    const std::vector<Vec3>& x = surface.vertices;
    volume += dot(x[a], crossProduct(x[b], x[c])) / 6;
  }
  for (const auto& [edge, count] : sides) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(sides.count({edge.second, edge.first}), 1u);
  }
  EXPECT_GT(volume, 30000);  // cm3; a body of this size has 60 litres with legs and head
  EXPECT_LT(volume, 60000);
}

TEST(DrapeForm, LeavesOutPartsThatAreNotCovered) {
  const Form form = formOf("m");
  const Vec3 wrist = form.tube(BodyPart::kLeftArm).axis().world({0, 0, -50});
  EXPECT_LT(form.distance(wrist, nullptr), 0);
  EXPECT_GT(form.distance(wrist, kTorsoAndNeck, nullptr), 20);
}

TEST(DrapeForm, RefusesMeasurementsThatNobodyHas) {
  Measures m = *measuresOf("M");
  m.waist = std::numeric_limits<double>::quiet_NaN();
  ASSERT_FALSE(Form::make(m).ok());
  EXPECT_EQ(Form::make(m).error().message, "The body's waist must be between 5 and 400 cm.");
  m = *measuresOf("M");
  m.knee_depth = 20;
  EXPECT_FALSE(Form::make(m).ok());
  EXPECT_EQ(measuresOf("xxl"), nullptr);
}

}  // namespace
}  // namespace seamwise
