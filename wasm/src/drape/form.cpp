#include "drape/form.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "drape/turn.h"

namespace seamwise {
namespace {

// Fillet size between tubes. [cm]
constexpr double kFillet = 2.5;
// Fillet size between the legs at the crotch, smaller so that trousers fit between them. [cm]
constexpr double kBetweenLegs = 0.9;

}  // namespace

double Form::distance(const Vec3& p, BodyParts parts, Vec3* gradient) const {
  struct Near {
    bool any = false;
    double distance = 1e9;
    Vec3 gradient = Vec3::Zero();
  };
  const auto join = [&](Near* to, const Near& other, double fillet = kFillet) {
    if (!other.any) return;
    double weight = 1;
    to->distance =
        to->any ? smoothLeast(to->distance, other.distance, fillet, &weight) : other.distance;
    to->gradient = to->gradient * (1 - weight) + other.gradient * weight;
    to->any = true;
  };
  const auto near = [&](BodyPart part) {
    Near found;
    if (!(parts & only(part))) return found;
    found.any = true;
    const Tube& tube = part == BodyPart::kTorso ? torso(parts & kLegs) : this->tube(part);
    found.distance = tube.distance(p, gradient ? &found.gradient : nullptr);
    return found;
  };
  Near all = near(BodyPart::kTorso);
  // Returns whether a tube has no influence on the union. The margin is twice the required
  // distance, because distances of tubes are approximate.
  const auto isFar = [&](BodyPart part) {
    return all.any && tube(part).leastDistance(p) / 2 > all.distance + 1.25 * kFillet;
  };
  for (const BodyPart part : {BodyPart::kNeck, BodyPart::kHead})
    if (!isFar(part)) join(&all, near(part));
  // Smooth unions depend on their order. Left and right are united first, so that neither takes
  // precedence.
  const auto joinBoth = [&](BodyPart left, BodyPart right, double fillet) {
    if (isFar(left) && isFar(right)) return;
    Near both = near(left);
    join(&both, near(right), fillet);
    join(&all, both);
  };
  joinBoth(BodyPart::kLeftArm, BodyPart::kRightArm, kFillet);
  joinBoth(BodyPart::kLeftLeg, BodyPart::kRightLeg, kBetweenLegs);
  if (gradient) *gradient = all.gradient;
  return all.distance;
}

double Form::girthAround(double height, BodyParts parts) const {
  // Points of the left half of the section, found by Newton's method within bounds. Rays between
  // the legs find none, and end in the middle.
  constexpr int kRays = 49, kSteps = 30;
  constexpr double kAtSurface = 1e-3;  // cm
  const Vec3 middle(0, height,
                    tube(BodyPart::kTorso).section(height - measures_.waist_height).middle);
  const double outside = 0.35 * std::max(measures_.hip, measures_.bust);
  std::array<Vec3, kRays> points;
  for (int ray = 0; ray < kRays; ++ray) {
    const Turn turn = turnOfDegrees(180.0 * ray / (kRays - 1));
    const Vec3 outward(turn.sine, 0, turn.cosine);
    double low = 0, high = outside, radius = outside, off = 1;
    for (int step = 0; step < kSteps && std::abs(off) > kAtSurface; ++step) {
      points[ray] = middle + radius * outward;
      Vec3 gradient;
      off = distance(points[ray], parts, &gradient);
      (off > 0 ? high : low) = radius;
      radius -= off / dot(gradient, outward);
      if (!(radius > low && radius < high)) radius = (low + high) / 2;
    }
  }
  // Cauchy's formula: the perimeter of the convex hull is the integral of its extent over the
  // directions.
  double sum = 0;
  for (int side = 0; side < 2 * (kRays - 1); ++side) {
    const Turn turn = turnOfDegrees(180.0 * side / (kRays - 1));
    double most = 0;
    for (const Vec3& p : points) {
      const double along = turn.cosine * (p.z() - middle.z());
      most = std::max(most, along + std::abs(turn.sine) * p.x());
    }
    sum += most;
  }
  return sum * kPi / (kRays - 1);
}

}  // namespace seamwise
