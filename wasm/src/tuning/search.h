#pragma once
#include <cstddef>
#include <optional>

namespace seamwise {

/// Budget of a search for a print of up to four symmetries besides its shifts; more symmetries need
/// more work. Work is counted in distance evaluations, never in seconds, so that results do not
/// depend on the machine. The defaults are those of a search without a start. Measured, as below:
/// "The search" (samples, idle, evaluations), "Shares" (shares, hits); trees chosen.
struct SearchBudget {
  int trees = 40;            ///< least number of spanning-tree starts for each component
  double idle = 12;          ///< steps without gain that end it, for each free piece and four more
  int hits = 12;             ///< starts ending at the same, best answer that end it
  double evaluations = 5e6;  ///< element distances that end it, for each free piece
  double samples = 12;       ///< samples along the print's shortest repeat during the search
  int shares = 4;            ///< number of parts of this budget, each with its own starts: see
                             ///< SearchShare
  /// Work for a proof that no better answer exists, as a share of `evaluations`; unset: a little,
  /// if that may be enough.
  std::optional<double> proof = {};
  bool operator==(const SearchBudget&) const = default;
};

/// Constants of the alignment search of method `best`. *Measured* names a section of
/// docs/experiments.md that compares other values. *Chosen* values were compared with no others.
/// Costs are in cm2; work is counted in element distances.
struct SearchTuning {
  // --- budgets of searches

  /// Budget of a search under slack, which starts with answers at rest. Measured: "Slack and
  /// starts" (evaluations, samples); idle and trees are adapted to them.
  static constexpr SearchBudget kUnderSlack{8, 8, 12, 3e6, 6, 4};
  /// Budget of a search continued with other weights or pins. Measured: "Warm starts"; hits chosen.
  static constexpr SearchBudget kNearby{2, 3, 8, 1e6, 12, 1};
  /// Budget of a search after a rotation of the print alone, whose start differs from the best
  /// answer only by rounding: one step, then polishing. Chosen.
  static constexpr SearchBudget kTouchUp{0, 0, 0, 5e6, 12, 1};

  /// Number of symmetries above which all limits grow with (symmetries / this)^(5/4). Measured:
  /// "Prints of many symmetries".
  static constexpr double kSymmetries = 4;
  /// Pieces above which patience and distances of each piece grow in proportion. Measured:
  /// "Garments of many pieces".
  static constexpr double kManyPieces = 10;
  /// Pieces below which both grow in inverse proportion. Measured: "Garments of few pieces".
  static constexpr double kFewPieces = 8;
  /// Greatest growth factor of both. Measured: "Garments of few pieces" (2 against 3).
  static constexpr double kMostPatience = 2;
  /// Pieces added to those of a component in the limit of steps without gain. Chosen.
  static constexpr double kPatiencePieces = 4;
  /// Pieces above which distances grow only with the square root of their number. Chosen, so that
  /// a garment does not take minutes.
  static constexpr double kCountedPieces = 40;
  /// Least number of samples of a seam. Chosen.
  static constexpr int kFewestSamples = 4;

  // --- starts and regrowths

  /// Share of fresh starts in the steps after the first trees. Measured: "The search" (7, 5 and 3
  /// of 10).
  static constexpr double kFreshShare = 0.7;
  /// Greatest product of that share and the number of pieces. Measured: "Garments of many pieces".
  static constexpr double kFreshPieces = 5;
  /// Share of fresh starts with pieces at random positions instead of grown ones. Measured: "The
  /// search" (3, 7 of 10).
  static constexpr double kScattered = 0.3;
  /// Share of regrowths of another good answer than the best. Chosen.
  static constexpr double kOtherAnswer = 0.3;
  /// Share of regrowths that start at a random position, apart from the remaining pieces. Chosen.
  static constexpr double kDetached = 0.5;
  /// Share of neighbours that a regrown part leaves in place. Chosen.
  static constexpr double kSkipped = 0.35;
  /// Share of pieces placed at the second best candidate. Measured: "The search" (1 in 2, 5, 7).
  static constexpr double kSecondBest = 0.5;
  /// Random stretches of a seam that align a piece, besides the whole seam. Measured: "The search"
  /// (0, 2, 4, 8).
  static constexpr int kStretches = 4;
  /// Relative difference of two stretches of a seam above which edges are aligned in step. Chosen;
  /// "Prints of many symmetries" shows the benefit of such edges.
  static constexpr double kEased = 0.1;
  /// Random directions tried for images with the distance of two edges. Chosen.
  static constexpr int kDirections = 8;
  /// Limits on the number of slides tried along a mirror line, one per cm of its period. Chosen.
  static constexpr int kFewestSlides = 5, kMostSlides = 12;

  // --- improving an answer; costs as multiples of another

  /// Newton steps of newly placed pieces before the answer is compared. Measured: "The search"
  /// (twice as many).
  static constexpr int kFreshIterations = 3;
  /// Rounds of moves of single pieces, and Newton steps of all pieces after each. Chosen.
  static constexpr int kRounds = 4, kRoundIterations = 4;
  /// Cost, over the best, above which an answer is dropped at once. Measured: "The search" (2, and
  /// 1.5 with a margin).
  static constexpr double kPruned = 1.5;
  /// Cost, over the best, up to which an answer is improved further. Chosen.
  static constexpr double kClose = 1.1;
  /// Cost of a piece at another position, over its current cost, up to which it is refined. Chosen.
  static constexpr double kWorthRefining = 1.5;
  /// Least gain of a moved piece, as a share of its cost. Chosen.
  static constexpr double kMoveGain = 1e-4;
  /// Gain that ends a run of steps without gain, as a share of the cost. Chosen.
  static constexpr double kGain = 1e-5;
  /// Gain of a Newton step below which iterating ends, as a share of the cost. Chosen.
  static constexpr double kSlowGain = 1e-4;
  /// Relative difference of costs below which two answers count as one. Chosen.
  static constexpr double kSameAnswer = 2e-3;
  /// Mean distance below which single precision allows no improvement. [cm] Chosen.
  static constexpr double kPerfectDistance = 2e-5;
  /// Cost below which the print matches without shaping. [cm2] Chosen.
  static constexpr double kPerfectCost = 1e-3;
  /// Distance below which Gauss-Newton weights 1/d grow no more. [cm] Chosen.
  static constexpr double kLeastDistance = 0.02;

  // --- the best few, on all edges

  /// Answers kept of each component. Measured: "The search" (3 against 16).
  static constexpr std::size_t kFinalists = 16;
  /// Newton steps before the finalists to polish are selected. Chosen.
  static constexpr int kFinalistIterations = 3;
  /// Number of finalists to polish. Chosen.
  static constexpr std::size_t kPolished = 12;
  /// Greatest number of Newton steps of each. Chosen.
  static constexpr int kPolishIterations = 30;
  /// Relative difference of costs below which answers are equally good. Chosen.
  static constexpr double kEqualCost = 1e-6;

  // --- mismatch that shaping can remove ("under slack")

  /// Slack over the greatest change of a vertex. Measured: "Seams no worse than by placing alone"
  /// (1.3, 1.6, 2.0).
  static constexpr double kSlack = 1.6;
  /// Share of a distance within the slack that counts. Measured: same section (0.1, 0.2).
  static constexpr double kLeak = 0.1;
  /// Factor of a seam's mismatch above its limit. Measured: same section (3, 6, 12).
  static constexpr double kBeyondLimit = 6;
  /// Root mean square of a seam's distances under its best join, over the slack, above which the
  /// seam is assumed to keep its line. Chosen.
  static constexpr double kShapedUpTo = 2;
  /// Share of a removable mismatch that is assumed to remain after shaping. Chosen.
  static constexpr double kLeftByShaping = 0.15;
  /// Greatest remaining share of a mismatch at which shaping pays off. Chosen.
  static constexpr double kWorthShaping = 0.7;

  // --- work of other kinds, in element distances; ratios of times on one machine

  /// Multiplications of the normal equations per distance. Chosen.
  static constexpr double kMultiplications = 20;
  /// Distances per sample: for placing both points, and for each coset that a fold leaves. Chosen.
  static constexpr double kPlacingWork = 4, kFoldWork = 1.5;
  /// Distances per sample and element of a Newton step. Chosen.
  static constexpr double kModelWork = 3;
  /// Distances between two reports, some milliseconds of work. Chosen.
  static constexpr double kStepWork = 1e6;
};

}  // namespace seamwise
