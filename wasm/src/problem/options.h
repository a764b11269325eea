#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "alignment/model/alignment.h"
#include "pattern/garment.h"

namespace seamwise {

enum class Method : std::uint8_t { kBest, kPaper, kWs19 };

/// What shaping may do to edges that are sewn to nothing: hems, necklines, fronts.
enum class OpenEdges : std::uint8_t {
  kKept,  ///< they keep their line: their vertices move along it only
  kFree
};

struct GrainRule {
  GrainLock lock = GrainLock::kFree;
  double tolerance = 0;  ///< rad
};

/// What is said about one piece; unset: as for all, and as in the file.
struct PieceGrain {
  std::optional<GrainRule> rule;
  std::optional<double> line;  ///< direction of the grain line of the face-up piece. [rad]
};

/// Everything about a solve that is neither garment nor print. Names follow the options file.
struct SolveOptions {
  Method method = Method::kBest;
  std::uint32_t seed = 1;
  double max_change_cm = 1.0;  ///< no outline vertex moves further than this from its rest position
  double edge_length_cm = 1.0;   ///< greatest distance of outline vertices, at most 1.05 on a seam
  std::optional<double> alpha;   ///< weight of the conformal energy; unset: the method's own choice
  bool continuous_only = false;  ///< forbid mirrored seams
  std::optional<bool>
      average_seam_shapes;    ///< Wolff et al. 2019, 3.3; unset: the method's own choice
  int starts = 1;             ///< of the sweeps of paper and ws19
  bool clip_targets = false;  ///< of paper and ws19: within the greatest change
  GrainRule grain;            ///< for pieces without a rule of their own
  std::map<int, PieceGrain> piece_grain;  ///< by piece index
  std::map<int, Alignment> pins;          ///< by piece index
  std::map<int, double> weights;          ///< by stitch number
  std::vector<int> unmatched;             ///< stitch numbers
  std::vector<int> plain;                 ///< piece indices
  std::vector<MatchLine> matches;
  std::vector<EdgeRef> locked;  ///< edges that stay as drafted
  OpenEdges open_edges = OpenEdges::kKept;
  /// How long to search, as a multiple of what is usual; more never ends worse.
  double effort = 1;
  /// Work for a proof of the alignment, as a multiple of the search's; unset: a little, where that
  /// may be enough.
  std::optional<double> proof;

  /// Whether the result tells of other alignments that fit about as well.
  bool other_alignments = false;

  /// Empty when usable, else one sentence that names the field.
  std::string problem() const;
};

}  // namespace seamwise
