#pragma once
#include <vector>

#include "deform/fitting_plan.h"
#include "deform/part_deformation.h"
#include "pattern/garment.h"
#include "seam/ideal_line.h"

namespace seamwise {

/// Rules that fitting keeps besides those of the pattern.
struct FittingRules {
  bool continuous_only = false;  ///< forbid mirrored seams
  bool average_shapes = false;   ///< seam lines take the mean of both sides' turning angles
  std::vector<EdgeRef> locked;   ///< edges that stay as drafted
};

/// Deforms all parts together so that the print meets at the seams: in turns, the two sides of
/// every seam get their common middle (in print space, through the seam's join) or their averaged
/// line as target, and every part takes a Newton step towards its targets. Weights 1/d make the sum
/// of distances fall, not of squares.
class SeamFitting {
 public:
  /// @param plan   for this pattern; it and the others outlive the fitting
  SeamFitting(const FittingPlan& plan, const Pattern& pattern, const WallpaperGroup& group,
              const FittingRules& rules);

  /// How hard each seam pulls, as a multiple of its weight; 1 at first. A seam of pull 0 keeps its
  /// drafted line; only its end vertices may move, with other seams.
  void setPulls(const std::vector<double>& pulls);

  /// Chooses each seam's join for the present shapes.
  void chooseJoins(const std::vector<Alignment>& at);
  /// New targets, then one step of every part.
  void step(const std::vector<Alignment>& at);

  /// New targets for one part: the partners' present seam lines, half way.
  void aimAtPartners(const PartDeformation& deformation, const std::vector<Alignment>& at);

  /// The state of every part, which steps change; joins are no part of it.
  std::vector<PartDeformation::State> states() const;
  void setStates(std::vector<PartDeformation::State> states);
  /// The state of every part as drafted.
  std::vector<PartDeformation::State> restStates() const;

  std::vector<PartDeformation>& deformations() { return deformations_; }
  const std::vector<PartDeformation>& deformations() const { return deformations_; }
  const Parts& parts() const { return plan_.parts; }
  /// Index of the part that a piece, or what mirrors it, belongs to.
  int partIndexOf(int piece) const { return plan_.parts.pieces[piece].part; }
  const Shapes& shapes() const { return shapes_; }
  const std::vector<Join>& joins() const { return joins_; }
  int factorisations() const;

  /// Updates shapes() from those of the parts.
  void collectShapes();
  /// Whether a piece's outline crosses itself.
  bool crosses(int piece) const;

 private:
  void addTarget(int piece, int vertex, const Vec2& position, double weight,
                 const PartDeformation* only);
  void aim(const std::vector<Alignment>& at, const PartDeformation* only);
  bool isLocked(int piece, int vertex) const;
  void lock();
  IdealLines linesOf(const Seam& seam, const Join& join, const std::vector<Alignment>& at) const;

  const FittingPlan& plan_;
  const Pattern& pattern_;
  const WallpaperGroup& group_;
  FittingRules rules_;
  std::vector<PartDeformation> deformations_;
  std::vector<Join> joins_;
  std::vector<double> pulls_;              ///< per seam
  std::vector<std::vector<char>> locked_;  ///< per part and its vertices
  Shapes shapes_;
};

}  // namespace seamwise
