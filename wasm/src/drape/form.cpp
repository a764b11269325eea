#include "drape/form.h"

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
    found.distance = tube(part).distance(p, gradient ? &found.gradient : nullptr);
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

}  // namespace seamwise
