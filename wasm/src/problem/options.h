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

/// Treatment of unsewn edges by shaping: hems, necklines, fronts.
enum class OpenEdges : std::uint8_t {
  kKept,  ///< they keep their line: their vertices move only along it
  kFree
};

/// Default weights of seams.
enum class Visibility : std::uint8_t {
  kByPlace,  ///< by how much a seam is seen at its place on the body
  kEven      ///< the same for all
};

struct GrainRule {
  GrainLock lock = GrainLock::kFree;
  double tolerance = 0;  ///< rad
};

/// Grain options of one piece; unset members use the rule for all pieces and the file's line.
struct PieceGrain {
  std::optional<GrainRule> rule;
  std::optional<double> line;  ///< direction of the grain line of the face-up piece. [rad]
};

/// All settings of a solve apart from garment and print. Names follow the options file.
struct SolveOptions {
  Method method = Method::kBest;
  std::uint32_t seed = 1;
  double max_change_cm = 1.0;  ///< no outline vertex moves further than this from its rest position
  double edge_length_cm = 1.0;   ///< greatest distance of outline vertices, at most 1.05 on a seam
  std::optional<double> alpha;   ///< weight of the conformal energy; unset: the method's own choice
  bool continuous_only = false;  ///< forbid mirrored seams
  std::optional<bool>
      average_seam_shapes;    ///< Wolff et al. 2019, 3.3; unset: the method's own choice
  int starts = 1;             ///< number of starts of the sweeps of paper and ws19
  bool clip_targets = false;  ///< limits targets of paper and ws19 to the greatest change
  GrainRule grain;            ///< for pieces without a rule of their own
  std::map<int, PieceGrain> piece_grain;  ///< keys are piece indices
  std::map<int, Alignment> pins;          ///< keys are piece indices
  std::map<int, double> weights;          ///< keys are stitch numbers
  std::vector<int> unmatched;             ///< stitch numbers
  std::vector<int> plain;                 ///< piece indices
  std::vector<MatchLine> matches;
  std::vector<EdgeRef> locked;  ///< edges that stay as drafted
  OpenEdges open_edges = OpenEdges::kKept;
  Visibility visibility = Visibility::kByPlace;
  /// Search effort as a multiple of the usual one; a greater effort never gives a worse result.
  double effort = 1;
  /// Work for a proof of the alignment, as a multiple of the search's; unset: a little, if that may
  /// be enough.
  std::optional<double> proof;

  /// Adds other alignments that fit about as well to the result.
  bool other_alignments = false;

  /// Returns one sentence that names an invalid field; empty if all are valid.
  std::string problem() const;
};

}  // namespace seamwise
