#pragma once
#include <optional>
#include <vector>

#include "drape/parts.h"
#include "drape/wrap.h"
#include "pattern/garment.h"
#include "pattern/pattern.h"

namespace seamwise {

/// A garment as its file hangs it: what it asks of a body. Heights are those of the file, before
/// it is lifted onto the body.
class HungGarment {
 public:
  /// @param form any body that hang() took the garment on.
  HungGarment(const Garment& garment, const Pattern& pattern, const Form& form,
              const Hanging& hanging);

  /// The rings about a part of the body, 1 cm apart.
  const std::vector<WornGirth>& girths(BodyPart part) const {
    return girths_[static_cast<int>(part)];
  }
  double top() const { return top_; }  ///< of the highest point, cm
  /// Of the edge that it ends in at its top. [cm]
  double topGirth() const { return top_girth_; }
  double topLow() const { return top_low_; }  ///< the lowest height of that edge, cm
  bool hasLegs() const { return crotch_.has_value(); }
  double crotch() const { return *crotch_; }  ///< height of the lowest point between two legs, cm
  bool hasShoulders() const { return shoulder_ > 0; }
  double neck() const { return neck_; }  ///< from the middle to where shoulder seams begin, cm
  double shoulder() const { return shoulder_; }  ///< and to where they end, cm
  bool hasCollar() const;
  bool hasSleeves() const { return !girths(BodyPart::kLeftArm).empty(); }

  /// The height of the torso's highest pieces so far from the middle; with `sewn_only` none where
  /// they end in an edge, as strapless ones do. [cm]
  std::optional<double> topOver(double x, bool sewn_only) const;

 private:
  Vec3 at(int piece, int vertex) const;
  void findShoulders();
  void findTop();

  const Pattern& pattern_;
  const Hanging& hanging_;
  std::vector<WornGirth> girths_[kBodyParts];
  std::vector<std::vector<char>> sewn_;  ///< per piece, per vertex
  double top_ = -1e9;
  std::optional<double> crotch_;
  double neck_ = 1e9, shoulder_ = 0;
  double top_girth_ = 0, top_low_ = 0;
};

}  // namespace seamwise
