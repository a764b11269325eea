#pragma once
#include <optional>
#include <vector>

#include "drape/parts.h"
#include "drape/wrap.h"
#include "pattern/garment.h"
#include "pattern/pattern.h"

namespace seamwise {

/// Garment hung as in its file, with the dimensions that a body has to match. Heights are those of
/// the file, before the garment is lifted onto the body.
class HungGarment {
 public:
  /// @param form   any body for which hang() accepts the garment
  HungGarment(const Garment& garment, const Pattern& pattern, const Form& form,
              const Hanging& hanging);

  /// Rings around a part of the body, 1 cm apart.
  const std::vector<WornGirth>& girths(BodyPart part) const {
    return girths_[static_cast<int>(part)];
  }
  double top() const { return top_; }  ///< height of the highest point, cm
  /// Length of the top edge. [cm]
  double topGirth() const { return top_girth_; }
  double topLow() const { return top_low_; }  ///< lowest height of the top edge, cm
  bool hasLegs() const { return crotch_.has_value(); }
  double crotch() const { return *crotch_; }  ///< height of the lowest point between two legs, cm
  bool hasShoulders() const { return shoulder_ > 0; }
  double neck() const { return neck_; }          ///< shoulder seams' start, cm from the middle
  double shoulder() const { return shoulder_; }  ///< shoulder seams' end, cm from the middle
  bool hasCollar() const;
  bool hasSleeves() const { return !girths(BodyPart::kLeftArm).empty(); }

  /// Returns the greatest height of the torso's pieces at x. It is empty if there are none or, with
  /// `sewn_only`, if they end in an open edge there, as in strapless garments. [cm]
  std::optional<double> topOver(double x, bool sewn_only) const;

 private:
  Vec3 at(int piece, int vertex) const;
  void findShoulders();
  void findTop();

  const Pattern& pattern_;
  const Hanging& hanging_;
  std::vector<WornGirth> girths_[kBodyParts];
  std::vector<std::vector<char>> sewn_;  ///< per piece, per vertex: whether a seam contains it
  double top_ = -1e9;
  std::optional<double> crotch_;
  double neck_ = 1e9, shoulder_ = 0;
  double top_girth_ = 0, top_low_ = 0;
};

}  // namespace seamwise
