#pragma once
#include <cstdint>
#include <vector>

#include "base/outcome.h"
#include "drape/measures.h"
#include "drape/tube.h"

namespace seamwise {

/// The parts of the body that a garment hangs on. Left and right are the wearer's: left is +x.
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

/// Some of them, bit by bit.
using BodyParts = unsigned;
constexpr BodyParts only(BodyPart part) { return 1u << static_cast<int>(part); }
inline constexpr BodyParts kTorsoAndNeck = only(BodyPart::kTorso) | only(BodyPart::kNeck);
inline constexpr BodyParts kArms = only(BodyPart::kLeftArm) | only(BodyPart::kRightArm);
inline constexpr BodyParts kLegs = only(BodyPart::kLeftLeg) | only(BodyPart::kRightLeg);
inline constexpr BodyParts kWholeBody = (1u << kBodyParts) - 1;

/// A tailor's dummy of given measurements, in cm: it stands on the floor y = 0, faces +z, its left
/// is +x, its arms hang at 45 degrees. One tube per part of the body, in smooth union.
class Form {
 public:
  /// Errors: kNumber when a measurement is no number between 5 and 400 cm, or they contradict each
  /// other, naming it.
  static Outcome<Form> make(const Measures& measures);

  /// About the distance to the surface of these parts, negative inside, and its gradient: once
  /// continuously differentiable, the gradient of about unit length near the surface. [cm]
  double distance(const Vec3& p, BodyParts parts, Vec3* gradient) const;
  double distance(const Vec3& p, Vec3* gradient) const { return distance(p, kWholeBody, gradient); }

  const Tube& tube(BodyPart part) const { return tubes_[static_cast<int>(part)]; }
  const Measures& measures() const { return measures_; }
  double crotchHeight() const { return measures_.waist_height - measures_.body_rise; }  ///< cm
  double napeHeight() const { return measures_.waist_height + measures_.back_length; }  ///< cm
  Vec3 shoulderPoint() const;  ///< the left one, cm

 private:
  explicit Form(const Measures& measures);

  Measures measures_;
  std::vector<Tube> tubes_;  ///< by BodyPart
};

}  // namespace seamwise
