#pragma once
#include <vector>

#include "deform/fitting_plan.h"
#include "deform/part_deformation.h"
#include "pattern/garment.h"
#include "seam/ideal_line.h"

namespace seamwise {

/// Rules of fitting in addition to those of the pattern.
struct FittingRules {
  bool continuous_only = false;  ///< forbid mirrored seams
  bool average_shapes = false;   ///< seam lines have the mean of both sides' turning angles
  std::vector<EdgeRef> locked;   ///< edges that stay as drafted
};

/// Deforms all parts together so that the print meets at the seams. Both sides of every seam have a
/// target: their common middle (in print space, through the seam's join) or their averaged line.
/// Targets and Newton steps of every part alternate. Weights 1/d minimise the sum of distances, not
/// of squares.
class SeamFitting {
 public:
  /// @param plan   the plan of this pattern; it and the other arguments outlive the fitting
  SeamFitting(const FittingPlan& plan, const Pattern& pattern, const WallpaperGroup& group,
              const FittingRules& rules);

  /// Sets the pull of each seam, as a multiple of its weight; 1 at first. A seam of pull 0 keeps
  /// its drafted line; only its end vertices may move, with other seams.
  void setPulls(const std::vector<double>& pulls);

  /// Chooses each seam's join for the current shapes.
  void chooseJoins(const std::vector<Alignment>& at);
  /// Sets new targets, then takes one step of every part.
  void step(const std::vector<Alignment>& at);

  /// Sets new targets for one part: half way to the partners' current seam lines.
  void aimAtPartners(const PartDeformation& deformation, const std::vector<Alignment>& at);

  /// The state of every part, which steps change; it excludes the joins.
  std::vector<PartDeformation::State> states() const;
  void setStates(std::vector<PartDeformation::State> states);
  /// The state of every part as drafted.
  std::vector<PartDeformation::State> restStates() const;

  std::vector<PartDeformation>& deformations() { return deformations_; }
  const std::vector<PartDeformation>& deformations() const { return deformations_; }
  const Parts& parts() const { return plan_.parts; }
  /// Index of the part with the vertices of a piece, or with those of its mirror twin.
  int partIndexOf(int piece) const { return plan_.parts.pieces[piece].part; }
  const Shapes& shapes() const { return shapes_; }
  const std::vector<Join>& joins() const { return joins_; }
  int factorisations() const;

  /// Updates shapes() from the parts.
  void collectShapes();
  /// Returns whether a piece's outline crosses itself.
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
  std::vector<std::vector<char>> locked_;  ///< per part and vertex
  Shapes shapes_;
};

}  // namespace seamwise
