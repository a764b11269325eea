#pragma once
#include <optional>
#include <string>
#include <vector>

#include "alignment/alignment.h"
#include "alignment/freedom.h"
#include "pattern/garment.h"
#include "pattern/pattern.h"
#include "wallpaper/group.h"

namespace seamwise {

/// A seam as the alignment search sees it: pairs of points that should fall on equivalent points of the
/// print, in the coordinates of the leading pieces (a mirrored follower's points are mapped back to its
/// leader, where the print is equivalent).
struct MatchSeam {
  int a = -1, b = -1;         ///< leaders; may be equal
  bool reversing = false;     ///< exactly one side was mapped: continuous needs a mirrored element
  std::vector<Vec2> pa, pb;   ///< edge midpoints, cm
  std::vector<Vec2> da, db;   ///< directions of those edges in sewing order
  std::vector<double> w;      ///< seam weight x mean edge length, cm
  double weight = 0;          ///< sum of w
  int seam = -1;              ///< index in Pattern::seams, -1: a match line
};

/// The variables of an alignment: one leader per mirrored pair or single piece.
struct Leader {
  int piece = -1;
  Freedom freedom;
  Vec2 centre = Vec2::Zero();  ///< of the piece's matched points; turns are about it
  std::vector<int> seams;      ///< indices in MatchProblem::seams
};

/// What a piece's alignment must keep besides symmetry.
struct PieceRule {
  std::optional<Alignment> pin;
  std::vector<double> angles;  ///< admissible angles, rad; empty: any
  double tolerance = 0;        ///< rad
};

/// What the alignment must heed besides the seams.
struct MatchRules {
  std::vector<PieceRule> pieces;  ///< per piece: pin and grain
  std::vector<MatchLine> lines;   ///< lines that lie on each other unsewn, in rest coordinates
  bool continuous_only = false;   ///< forbid mirrored seams
};

using Alignments = std::vector<Alignment>;

/// All seams that count, on the leading pieces, and the print's group. Distances are evaluated in the
/// reduced lattice basis, where the nearest lattice vector is found by rounding.
class MatchProblem {
 public:
  std::vector<Leader> leaders;
  std::vector<MatchSeam> seams;
  struct Follow {
    int leader = -1;
    bool mirrored = false;
    RigidMotion map;  ///< leader piece -> this piece, when mirrored
  };
  std::vector<Follow> pieces;  ///< per piece of the pattern
  WallpaperGroup group;
  bool continuous_only = false;

  explicit MatchProblem(WallpaperGroup wallpaper);

  /// Where a piece lies, as a map from its coordinates to reduced lattice coordinates.
  struct Pose {
    double m00, m01, m10, m11, t0, t1;
  };
  Pose pose(const Alignment& at) const;

  /// Sum of w max(0, d - slack) + leak d over one seam (leak only when slack > 0). [cm2]
  double seamCost(const MatchSeam& seam, const Pose& a, const Pose& b, double slack = 0) const;
  /// Over all seams.
  double cost(const Alignments& at, double slack = 0) const;

  /// The element and lattice shift that bring pb[i] nearest to pa[i]. `element` indexes
  /// group.elements(); target is A y + a + T in print space.
  struct Nearest {
    int element = 0;
    Vec2 residual;  ///< x - (A y + a + T)
  };
  Nearest nearest(const MatchSeam& seam, const Vec2& x, const Vec2& y) const;

  /// Whether `element` may join this seam: a continuous join or, if allowed, a mirrored one.
  bool allows(const MatchSeam& seam, const Element& element) const {
    return !continuous_only || element.mirrored == seam.reversing;
  }

  /// The same problem with at most `most` samples a seam, for coarse evaluation.
  MatchProblem coarsened(int most) const;

  /// Alignments of all pieces from those of the leaders, and back.
  Alignments expanded(const Alignments& of_leaders) const;
  Alignments ofLeaders(const Alignments& of_pieces) const;

  /// Small share of the distance that counts inside the slack, so that ties go to the better fit.
  static constexpr double kLeak = 0.1;

 private:
  Mat2 to_reduced_;                ///< print -> reduced lattice coordinates
  double g11_, g12_, g22_;         ///< metric in reduced coordinates, 0 <= 2 g12 <= g11 <= g22
  std::vector<Pose> reduced_elements_;
};

/// Makes the problem for a pattern in the given shapes (per piece, per vertex, cm).
/// @param mirrors    pairs merge into one leader, single pieces must lie on a mirror line; the group
///                   must carry them
/// @param notes      gets a sentence for each rule that a mirrored piece cannot keep; may be null
MatchProblem makeMatchProblem(const Pattern& pattern, const Shapes& shapes,
                              const std::vector<Mirror>& mirrors, const MatchRules& rules,
                              const WallpaperGroup& group, std::vector<std::string>* notes);

}  // namespace seamwise
