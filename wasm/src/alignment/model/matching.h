#pragma once
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "alignment/model/admissible_alignments.h"
#include "alignment/model/alignment.h"
#include "alignment/model/grain.h"
#include "pattern/garment.h"
#include "pattern/pattern.h"
#include "wallpaper/group.h"

namespace seamwise {

/// The data of a stretch of a seam that determine the best rigid motion of one side onto the other.
struct Stretch {
  Vec2 mean_a = Vec2::Zero(), mean_b = Vec2::Zero();  ///< weighted means of pa and pb
  Mat2 covariance = Mat2::Zero();                     ///< sum of w (pa - mean_a) (pb - mean_b)^T
  bool operator==(const Stretch&) const = default;
};

/// A seam of the alignment search: pairs of points that should be at equivalent points of the
/// print, in the coordinates of the leading pieces. A mirrored follower's points are mapped back to
/// its leader, where the print is equivalent.
struct MatchSeam {
  int a = -1, b = -1;        ///< leaders; may be equal
  bool reversing = false;    ///< exactly one side was mapped: continuous needs a mirrored element
  std::vector<Vec2> pa, pb;  ///< edge midpoints, cm
  std::vector<Vec2> da, db;  ///< directions of those edges in sewing order
  std::vector<double> w;     ///< seam weight x mean edge length, cm
  double weight = 0;         ///< sum of w
  Stretch whole;
  int seam = -1;  ///< index in Pattern::seams, -1: a match line
  /// Mean mismatch beyond which no shape is worth having; the excess counts for more. [cm]
  double limit = std::numeric_limits<double>::infinity();

  /// The stretch of the edges first .. last - 1.
  Stretch stretch(std::size_t first, std::size_t last) const;
  bool operator==(const MatchSeam&) const = default;
};

/// The variables of an alignment: one leader per mirrored pair or single piece.
struct Leader {
  int piece = -1;
  AdmissibleAlignments admissible;
  Vec2 centre = Vec2::Zero();  ///< centre of the piece's matched points and of its turns
  std::vector<int> seams;      ///< indices in MatchProblem::seams
  bool operator==(const Leader&) const = default;
};

/// Restrictions of alignments in addition to the seams.
struct MatchRules {
  std::vector<PieceRule> pieces;  ///< per piece: pin and grain
  std::vector<MatchLine> lines;   ///< unsewn lines that have to coincide, in rest coordinates
  bool continuous_only = false;   ///< forbid mirrored seams
};

using Alignments = std::vector<Alignment>;

/// All seams that count, on the leading pieces, and the print's group.
class MatchProblem {
 public:
  std::vector<Leader> leaders;
  std::vector<MatchSeam> seams;
  struct Follow {
    int leader = -1;
    bool mirrored = false;
    RigidMotion map;             ///< leader piece -> this piece, when mirrored
    std::vector<double> angles;  ///< wanted angles of a mirrored piece, rad; empty: any
    bool operator==(const Follow&) const = default;
  };
  std::vector<Follow> pieces;  ///< per piece of the pattern
  WallpaperGroup group;
  bool continuous_only = false;

  explicit MatchProblem(WallpaperGroup wallpaper) : group(std::move(wallpaper)) {}
  bool operator==(const MatchProblem&) const = default;

  /// Sum of w d over all seams. [cm2]
  double cost(const Alignments& at) const;

  /// The symmetries by which the print may meet across a seam.
  WallpaperGroup joining() const { return group.joining(continuous_only); }

  /// Returns whether `element` may join this seam: a continuous join or, if allowed, a mirrored
  /// one.
  bool allows(const MatchSeam& seam, const Element& element) const {
    return !continuous_only || element.mirrored == seam.reversing;
  }

  /// Alignments of all pieces from those of the leaders, and the reverse.
  Alignments expanded(const Alignments& of_leaders) const;
  Alignments ofLeaders(const Alignments& of_pieces) const;
};

/// Makes the problem for a pattern in the given shapes (per piece, per vertex, cm).
/// @param mirrors   pairs merge into one leader; single pieces must be on a mirror line, even off
///                  their grain; the group must carry them
MatchProblem makeMatchProblem(const Pattern& pattern, const Shapes& shapes,
                              const std::vector<Mirror>& mirrors, const MatchRules& rules,
                              const WallpaperGroup& group);

}  // namespace seamwise
