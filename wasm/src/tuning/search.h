#pragma once
#include <cstddef>
#include <optional>

namespace seamwise {

/// How long a search looks, for a print of up to four symmetries besides its shifts; for one of
/// more, it takes longer. Counted in distance evaluations, never in seconds, so that results do not
/// depend on the machine. The defaults are those of a search from nothing; measured, as below: "The
/// search" (samples, idle, evaluations), "Shares" (shares, hits); trees chosen.
struct SearchBudget {
  int trees = 40;            ///< spanning-tree starts for each component, at least
  double idle = 12;          ///< steps without gain that end it, for each free piece and four more
  int hits = 12;             ///< or starts that ended at the same, best answer
  double evaluations = 5e6;  ///< or element distances, for each free piece
  double samples = 12;       ///< along the print's shortest repeat, while searching
  int shares = 4;  ///< that all this is split into, each with starts of its own: see SearchShare
  /// Work for a proof that nothing better is left, as a share of `evaluations`; unset: a little,
  /// where that may be enough.
  std::optional<double> proof = {};
  bool operator==(const SearchBudget&) const = default;
};

/// Constants of the alignment search of method `best`. *Measured* names a section of
/// docs/experiments.md that compares other values; *chosen* are those that none were compared with.
/// Costs are cm2, work is counted in element distances.
struct SearchTuning {
  // --- how long a search looks

  /// Of a search under slack, which begins with answers at rest. Measured: "Slack and starts"
  /// (evaluations, samples); idle and trees go with them.
  static constexpr SearchBudget kUnderSlack{8, 8, 12, 3e6, 6, 4};
  /// Of a search that goes on with other weights or pins. Measured: "Warm starts"; hits chosen.
  static constexpr SearchBudget kNearby{2, 3, 8, 1e6, 12, 1};
  /// Of a search that only rounding keeps from the best, since only the print has turned: one step,
  /// then polishing. Chosen.
  static constexpr SearchBudget kTouchUp{0, 0, 0, 5e6, 12, 1};

  /// Symmetries from which on all limits grow, with (symmetries / this)^(5/4). Measured: "Prints of
  /// many symmetries".
  static constexpr double kSymmetries = 4;
  /// Pieces above which patience and distances of each piece grow in proportion. Measured:
  /// "Garments of many pieces".
  static constexpr double kManyPieces = 10;
  /// Pieces below which both grow in inverse proportion. Measured: "Garments of few pieces".
  static constexpr double kFewPieces = 8;
  /// Factor that both grow by at most. Measured: "Garments of few pieces" (2 against 3).
  static constexpr double kMostPatience = 2;
  /// Pieces added to those of a component where steps without gain are counted. Chosen.
  static constexpr double kPatiencePieces = 4;
  /// Pieces above which distances grow with the square root of their number only. Chosen, so that
  /// nobody waits minutes for one garment.
  static constexpr double kCountedPieces = 40;
  /// Samples of a seam, at least. Chosen.
  static constexpr int kFewestSamples = 4;

  // --- starts and regrowths

  /// Share of steps that start from nothing once the first trees are grown. Measured: "The search"
  /// (7, 5 and 3 of 10).
  static constexpr double kFreshShare = 0.7;
  /// The same times the number of pieces, where that is less. Measured: "Garments of many pieces".
  static constexpr double kFreshPieces = 5;
  /// Share of fresh starts whose pieces lie anywhere, not grown. Measured: "The search" (3, 7 of
  /// 10).
  static constexpr double kScattered = 0.3;
  /// Share of regrowths of another good answer than the best. Chosen.
  static constexpr double kOtherAnswer = 0.3;
  /// Share of regrowths that begin anywhere, apart from what stays. Chosen.
  static constexpr double kDetached = 0.5;
  /// Share of neighbours that a regrown part leaves in place. Chosen.
  static constexpr double kSkipped = 0.35;
  /// Share of pieces placed at the second best candidate. Measured: "The search" (1 in 2, 5, 7).
  static constexpr double kSecondBest = 0.5;
  /// Random stretches of a seam along which a piece is laid, besides the whole. Measured: "The
  /// search" (0, 2, 4, 8).
  static constexpr int kStretches = 4;
  /// Share of its length by which two stretches of a seam differ before edges are laid in step.
  /// Chosen; that such edges help: "Prints of many symmetries".
  static constexpr double kEased = 0.1;
  /// Directions in which images are sought that are as far apart as two edges. Chosen.
  static constexpr int kDirections = 8;
  /// Slides along a mirror line that are tried: as many as its period has cm, within these. Chosen.
  static constexpr int kFewestSlides = 5, kMostSlides = 12;

  // --- improving an answer; costs as multiples of another

  /// Newton steps of what was laid anew, before the answer is judged. Measured: "The search"
  /// (twice as many).
  static constexpr int kFreshIterations = 3;
  /// Rounds of moves of single pieces, and Newton steps of all after each. Chosen.
  static constexpr int kRounds = 4, kRoundIterations = 4;
  /// Cost, over the best, beyond which an answer is dropped at once. Measured: "The search" (2,
  /// and 1.5 with a margin).
  static constexpr double kPruned = 1.5;
  /// Cost, over the best, up to which an answer is improved further. Chosen.
  static constexpr double kClose = 1.1;
  /// Cost of a single piece elsewhere, over that where it lies, up to which it is refined. Chosen.
  static constexpr double kWorthRefining = 1.5;
  /// Gain that a moved piece has to bring, as a share of its cost. Chosen.
  static constexpr double kMoveGain = 1e-4;
  /// Gain that ends a run of steps without gain, as a share of the cost. Chosen.
  static constexpr double kGain = 1e-5;
  /// Gain of a Newton step below which iterating ends, as a share of the cost. Chosen.
  static constexpr double kSlowGain = 1e-4;
  /// Difference of costs, as a share, below which two answers count as one. Chosen.
  static constexpr double kSameAnswer = 2e-3;
  /// Mean distance below which nothing is left to find in single precision. [cm] Chosen.
  static constexpr double kPerfectDistance = 2e-5;
  /// Cost below which the print meets as the pieces lie. [cm2] Chosen.
  static constexpr double kPerfectCost = 1e-3;
  /// Distance below which Gauss-Newton weights 1/d grow no more. [cm] Chosen.
  static constexpr double kLeastDistance = 0.02;

  // --- the best few, on all edges

  /// Answers kept of each component. Measured: "The search" (3 against 16).
  static constexpr std::size_t kFinalists = 16;
  /// Newton steps that tell which of them go on. Chosen.
  static constexpr int kFinalistIterations = 3;
  /// Finalists that go on. Chosen.
  static constexpr std::size_t kPolished = 12;
  /// Newton steps of each, at most. Chosen.
  static constexpr int kPolishIterations = 30;
  /// Difference of costs, as a share, below which answers are as good as each other. Chosen.
  static constexpr double kEqualCost = 1e-6;

  // --- what shaping can take up ("under slack")

  /// Slack over the greatest change of a vertex. Measured: "Seams no worse than by placing alone"
  /// (1.3, 1.6, 2.0).
  static constexpr double kSlack = 1.6;
  /// Share of a distance within the slack that counts. Measured: same section (0.1, 0.2).
  static constexpr double kLeak = 0.1;
  /// Factor of what a seam misses by beyond its limit. Measured: same section (3, 6, 12).
  static constexpr double kBeyondLimit = 6;
  /// Root mean square of a seam's distances through its best join, over the slack, beyond which the
  /// seam is taken to keep its line. Chosen.
  static constexpr double kShapedUpTo = 2;
  /// Share of a mismatch that can be taken up which shaping is taken to leave. Chosen.
  static constexpr double kLeftByShaping = 0.15;
  /// Share of a mismatch that shaping may leave at most to be worth it. Chosen.
  static constexpr double kWorthShaping = 0.7;

  // --- work of other kinds, in element distances; ratios of times on one machine

  /// Multiplications of the normal equations for one distance. Chosen.
  static constexpr double kMultiplications = 20;
  /// Distances of one sample: to place both points, and for each coset that a fold leaves. Chosen.
  static constexpr double kPlacingWork = 4, kFoldWork = 1.5;
  /// Distances for a sample and element of a Newton step. Chosen.
  static constexpr double kModelWork = 3;
  /// Distances between two reports: some milliseconds. Chosen.
  static constexpr double kStepWork = 1e6;
};

}  // namespace seamwise
