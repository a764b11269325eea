#pragma once
#include <cstdint>
#include <vector>

#include "base/outcome.h"
#include "drape/measures.h"
#include "drape/tube.h"

namespace seamwise {

/// Body parts that a garment can hang on. Left and right are the wearer's: left is +x.
enum class BodyPart : std::uint8_t {
  kTorso,
  kNeck,
  kLeftArm,
  kRightArm,
  kLeftLeg,
  kRightLeg,
  kHead
};
inline constexpr int kBodyParts = 7;

/// Set of body parts, one bit each.
using BodyParts = unsigned;
constexpr BodyParts only(BodyPart part) { return 1u << static_cast<int>(part); }
inline constexpr BodyParts kTorsoAndNeck = only(BodyPart::kTorso) | only(BodyPart::kNeck);
inline constexpr BodyParts kArms = only(BodyPart::kLeftArm) | only(BodyPart::kRightArm);
inline constexpr BodyParts kLegs = only(BodyPart::kLeftLeg) | only(BodyPart::kRightLeg);
inline constexpr BodyParts kWholeBody = (1u << kBodyParts) - 1;

/// Dress form with given measurements, in cm. The floor is y = 0, the form faces +z, its left is
/// +x, and its arms point down at 45 degrees. It is a smooth union of one tube per body part.
class Form {
 public:
  /// Makes a form from measurements in cm.
  /// Errors: kNumber, naming a measurement outside 5 to 400 cm or a contradiction between
  /// measurements.
  static Outcome<Form> make(const Measures& measures);

  /// Returns the approximate distance to the surface of `parts`, negative inside, and its gradient.
  /// The distance is once continuously differentiable; the gradient has about unit length near the
  /// surface. [cm]
  double distance(const Vec3& p, BodyParts parts, Vec3* gradient) const;
  double distance(const Vec3& p, Vec3* gradient) const { return distance(p, kWholeBody, gradient); }

  const Tube& tube(BodyPart part) const { return tubes_[static_cast<int>(part)]; }
  /// Returns the torso as it ends with legs below it, or without them.
  const Tube& torso(bool has_legs) const { return has_legs ? over_legs_ : tubes_.front(); }
  /// Returns the length of a tape around a level section of `parts`. [cm]
  double girthAround(double height, BodyParts parts) const;
  const Measures& measures() const { return measures_; }
  double crotchHeight() const { return measures_.waist_height - measures_.body_rise; }  ///< cm
  double napeHeight() const { return measures_.waist_height + measures_.back_length; }  ///< cm
  Vec3 shoulderPoint() const;  ///< left shoulder point, cm

 private:
  explicit Form(const Measures& measures);
  void widenLegs();

  Measures measures_;
  Tube over_legs_;
  std::vector<Tube> tubes_;  ///< indexed by BodyPart
};

}  // namespace seamwise
