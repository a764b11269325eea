// Construction of a form from its measurements; form.cpp computes distances from it.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "drape/form.h"
#include "drape/turn.h"

namespace seamwise {
namespace {

// Height of the nape over the shoulder point, as a share of the back length. [1]
constexpr double kShoulderDrop = 0.09;

double between(double share, double from, double to) { return from + share * (to - from); }

Axis upright(const Vec3& origin) { return {origin, Vec3::UnitX(), Vec3::UnitZ(), Vec3::UnitY()}; }

// Half widths, half depths and middles follow a scanned average body (GarmentCode's mean_all),
// smoothed and with a woman's waist. Girths come from the measurements. The rounding of the lower
// end begins below the hip, unless legs continue the torso.
Tube torsoOf(const Measures& m, bool has_legs) {
  const double up = m.back_length, down = m.hip_depth;
  const Section chest{0.45 * up, 16.8, 12.6, 0.1, 0.2};
  const double broad = m.bust / chest.girth();
  const auto above = [&](double share, double width, double depth, double middle, double square) {
    return Section{share * up, width * broad, depth * broad, middle, square};
  };
  const std::vector<Section> sections = {
      Section{-m.body_rise - 10, 17.6, 11.2, -1.2, 0.2}.withGirth(0.93 * m.hip),
      Section{-down, 19.2, 12.5, -1.3, 0.25}.withGirth(m.hip),
      Section{-0.5 * down, 17.0, 11.8, -0.5, 0.2}.withGirth(between(0.62, m.waist, m.hip)),
      Section{0, 13.7, 10.4, 0.9, 0.15}.withGirth(m.waist),
      Section{0.12 * up, 14.2, 10.7, 0.7, 0.15}.withGirth(between(0.06, m.waist, m.bust)),
      Section{0.28 * up, 14.6, 11.0, 0.5, 0.15}.withGirth(between(0.3, m.waist, m.bust)),
      chest.withGirth(m.bust),
      above(0.66, 16.0, 10.3, -1.3, 0.3),
      above(0.82, 18.0, 8.0, -2.4, 0.4),
      above(0.95, 18.8, 5.8, -2.5, 0.3),
      above(1.15, 18.8, 4.6, -2.5, 0.3)};
  const double tip = m.shoulder_width / 2;
  // The shoulders slope from the side of the neck to the shoulder points.
  const double neck = m.neck / (2 * kPi) + 1, rise = (kShoulderDrop + 0.012) * up;
  const double slope = rise / (tip - neck);
  const double ridge = (1 - kShoulderDrop) * up + slope * (std::sqrt(tip * tip + 16) - 4);
  const TubeEnd bottom{has_legs ? -m.body_rise + 3 : -down - 9, 0, 9};
  return {upright({0, m.waist_height, 0}), sections, bottom, {ridge, slope, 5}};
}

Tube neck(const Measures& m) {
  const double r = m.neck / (2 * kPi);
  const auto ring = [&](double level, double middle, double share) {
    return Section{level, r * 0.97, r * 1.03, middle, 0.05}.withGirth(share * m.neck);
  };
  return {upright({0, m.waist_height + m.back_length, 0}),
          {ring(-12, -3.2, 1.2), ring(-4, -2.2, 1.1), ring(1, -1.2, 1), ring(5, 0, 0.98),
           ring(14, 1.5, 1)},
          {-10, 0, 2},
          {6.5, 0, 3}};
}

// Arm from the shoulder down to the hand, 45 degrees from the vertical; level 0 is the joint.
Tube arm(const Measures& m, const Vec3& shoulder, double side) {
  const double r = m.upper_arm / (2 * kPi);
  const Turn turn = turnOfDegrees(45);
  Axis axis;
  axis.up = Vec3(-side * turn.sine, turn.cosine, 0);
  axis.ahead = Vec3(side * turn.cosine, turn.sine, 0);
  axis.side = Vec3(0, 0, -side);
  axis.origin = Vec3(side * (shoulder.x() - r), shoulder.y() - 0.85 * r, shoulder.z());
  const double length = m.arm_length;
  const auto ring = [&](double level, double girth) {
    return Section{level, 1, 1, 0, 0}.withGirth(girth);
  };
  return {
      axis,
      {ring(-length - 10, m.wrist), ring(-length - 4, m.wrist * 1.02), ring(-length, m.wrist),
       ring(-0.55 * length, between(0.6, m.wrist, m.upper_arm)), ring(-0.22 * length, m.upper_arm),
       ring(0, m.upper_arm * 1.06), ring(8, m.upper_arm * 1.06)},
      {-length - 5, 0, 2},
      {1.1 * r, 0, 1.4 * r}};
}

// Leg from above the hip to the ankle, with a given girth at the level of the hip; level 0 is the
// crotch.
Tube leg(const Measures& m, double girth_at_hip, double side) {
  const double crotch = m.waist_height - m.body_rise, knee = m.waist_height - m.knee_depth;
  const double hip = std::max(m.waist_height - m.hip_depth, crotch - 2);
  const double apart = 0.152 * m.thigh + 1;
  const auto ring = [&](double height, double middle, double girth) {
    return Section{height - crotch, 1, 1, middle, 0}.withGirth(girth);
  };
  return {upright({side * apart, crotch, 0}),
          {ring(0, -2.5, m.ankle), ring(8, -2.5, m.ankle), ring(0.62 * knee, -2.8, 0.92 * m.knee),
           ring(knee, -1.4, m.knee), ring(between(0.5, knee, crotch), -0.8, 0.84 * m.thigh),
           ring(crotch - 5, -1, m.thigh), ring(hip, -1, girth_at_hip),
           ring(hip + 10, -1, 0.85 * girth_at_hip), ring(hip + 25, -1, 0.85 * girth_at_hip)},
          {3 - crotch, 0, 3},
          {hip - crotch + 6, 0, 5}};
}

// Egg-shaped head, for hoods.
Tube head(const Measures& m) {
  const double nape = m.waist_height + m.back_length;
  const auto ring = [&](double level, double middle, double share) {
    return Section{level, 7.7, 9.6, middle, 0}.withGirth(share * m.head);
  };
  return {upright({0, nape, 0}),
          {ring(0, 1, 0.6), ring(5, 1, 0.62), ring(10, 1, 0.86), ring(16, 0.8, 1),
           ring(21, 0.5, 0.93), ring(26, 0.5, 0.8)},
          {5, 0, 3},
          {24.5, 0, 8}};
}

}  // namespace

Form::Form(const Measures& measures) : measures_(measures), over_legs_(torsoOf(measures, true)) {
  const Vec3 shoulder = shoulderPoint();
  tubes_ = {torsoOf(measures, false),
            neck(measures),
            arm(measures, shoulder, 1),
            arm(measures, shoulder, -1),
            leg(measures, measures.thigh, 1),
            leg(measures, measures.thigh, -1),
            head(measures)};
  widenLegs();
}

// Finds the girth of the legs with which legs and torso have the girth of the hip, by the secant
// method: it is almost linear.
void Form::widenLegs() {
  const double height = measures_.waist_height - measures_.hip_depth;
  const auto missing = [&](double girth) {
    tubes_[static_cast<int>(BodyPart::kLeftLeg)] = leg(measures_, girth, 1);
    tubes_[static_cast<int>(BodyPart::kRightLeg)] = leg(measures_, girth, -1);
    return measures_.hip - girthAround(height, only(BodyPart::kTorso) | kLegs);
  };
  constexpr int kSteps = 4;
  constexpr double kAlmost = 0.05;  // cm
  const double least = 0.7 * measures_.thigh, most = 1.8 * measures_.thigh;
  double before = measures_.thigh, now = 1.15 * measures_.thigh;
  double missing_before = missing(before), missing_now = missing(now);
  for (int step = 0; step < kSteps && std::abs(missing_now) > kAlmost; ++step) {
    const double slope = (missing_now - missing_before) / (now - before);
    if (std::abs(slope) < 1e-3) break;
    before = std::exchange(now, std::clamp(now - missing_now / slope, least, most));
    if (before == now) break;
    missing_before = std::exchange(missing_now, missing(now));
  }
}

Vec3 Form::shoulderPoint() const {
  return {measures_.shoulder_width / 2,
          measures_.waist_height + (1 - kShoulderDrop) * measures_.back_length, -2.6};
}

Outcome<Form> Form::make(const Measures& m) {
  for (const MeasureName& measure : kMeasureNames)
    if (const double value = m.*measure.value; !(value >= 5 && value <= 400))
      return Error{Failure::kNumber,
                   "The body's " + std::string(measure.spoken) + " must be between 5 and 400 cm."};
  const auto refused = [](const char* what) {
    return Error{Failure::kNumber,
                 std::string("The body's measurements contradict each other: ") + what + "."};
  };
  if (m.body_rise <= 0.6 * m.hip_depth) return refused("the crotch lies above the hips");
  if (m.knee_depth <= m.body_rise + 10) return refused("the knee lies above the crotch");
  if (m.waist_height <= m.knee_depth + 15) return refused("the knee lies below the floor");
  if (m.shoulder_width <= m.neck / kPi + 6) return refused("the neck is wider than the shoulders");
  return Form(m);
}

}  // namespace seamwise
