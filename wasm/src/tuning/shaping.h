#pragma once
#include <cstddef>

namespace seamwise {

/// Constants of how method `best` shapes pieces: fitting, settling, and the rules that seams are
/// judged by. *Measured* names a section of docs/experiments.md; *rule* is what a result is to
/// keep, counted by "Rules" of docs/benchmarks.md; *chosen* were compared with no other values.
struct ShapingTuning {
  // --- weights of a part's energy: lengths in cm, energies per cm of outline

  /// Conformal energy, per cm2 of cloth. Chosen.
  static constexpr double kConformal = 0.3;
  /// Change of the outline's direction, per rad2 at a vertex; the same at a corner. Chosen.
  static constexpr double kBend = 12.0, kCornerBend = 4.0;
  /// Pull of the outline to its rest position, per cm2; of the interior, as a share of it. Chosen.
  static constexpr double kRestPull = 0.01, kInteriorPull = 1e-4;
  /// Change of an unsewn edge's length, per cm2. Chosen.
  static constexpr double kUnsewn = 20.0;
  /// Distance of an unsewn edge's vertices from its line, per cm2. Chosen.
  static constexpr double kLine = 2000.0;
  /// Augmented Lagrangian of the length of a sewn edge of 1 cm, per cm2. Shorter ones are held
  /// harder in proportion: many springs one after the other give way by as much as all of them do.
  /// Measured: held alike, a line of 0.1 cm edges came to its length in 70 steps in place of 20,
  /// and mostly was put to rest before (princess dress, pmm); the value itself is chosen.
  static constexpr double kLengthPenalty = 2e4;
  /// Penalty of what exceeds a vertex's reach, per cm2: pulls are about 1 per cm, so the excess is
  /// slight. Chosen.
  static constexpr double kReachPenalty = 4e3;

  // --- a Newton step

  /// Area of a triangle, as a share of that at rest, below which no step may bring it. Chosen.
  static constexpr double kLeastArea = 0.33;
  /// Length of a step, at most: beyond it the linearised lengths are worthless. [cm] Chosen.
  static constexpr double kLongestStep = 0.4;
  /// Share of a gap outside the piece that one side may close; two cannot cross. Chosen.
  static constexpr double kGapShare = 0.45;
  /// Straight distance, as a share of the way along the outline, below which two points face each
  /// other across a gap: where a line merely bends it is more. Chosen.
  static constexpr double kGapDetour = 0.6;

  // --- targets

  /// Mismatch below which targets pull no harder, with weights 1/d. [cm] Chosen.
  static constexpr double kLeastDistance = 0.05;
  /// Pull of a gathered seam, which cannot match all along, over that of another. Chosen.
  static constexpr double kGatheredPull = 0.3;
  /// How far a vertex may leave a line that is kept: the seam's mean then stays within 0.3 mm. [cm]
  /// Chosen.
  static constexpr double kLineReach = 0.02;
  /// Greatest change that shapes make use of: beyond it, outlines lose their lines and nothing is
  /// gained (docs/formats.md, maxChangeCm). [cm] Chosen.
  static constexpr double kMostReach = 2.0;
  /// Share of the greatest change that shapes are held to, since the penalty gives way; share by
  /// which a finished one may exceed that. Chosen.
  static constexpr double kReachShare = 0.985, kReachExcess = 0.012;

  // --- steps of fitting: in all, and of them from each start

  /// On the mesh as it is. Measured: "Coarse to fine" (7, 2).
  static constexpr int kSteps = 7, kTrialSteps = 2;
  /// On the coarser mesh. Measured: "Coarse to fine" (10, with 3 trial steps; 5 are chosen).
  static constexpr int kCoarseSteps = 10, kCoarseTrialSteps = 5;
  /// On the mesh as it is after coarse ones. Measured: "Coarse to fine" (1, 2, 3).
  static constexpr int kFineSteps = 2;
  /// More of these where pieces had to be laid anew. Chosen.
  static constexpr int kMoreFineSteps = 3;
  /// Edges of the coarser mesh's outlines, at most. [cm] Measured: "Coarse to fine" (2.1, 3.2).
  static constexpr double kCoarseEdge = 2.1;
  /// Sweeps that carry moves inwards from the outline; the next step balances the interior. Chosen.
  static constexpr int kProlongSweeps = 4;
  /// Steps between new joins and alignments. Measured: "Coarse to fine" (2, 3).
  static constexpr int kRealignEvery = 3;
  /// Newton steps of the alignment then. Chosen.
  static constexpr int kRealignIterations = 2;
  /// Steps after which also seams that pull are held to what placing alone leaves of them: by then,
  /// shaping has made them meet as far as it will. Chosen.
  static constexpr int kLimitedFrom = 6;

  // --- starts and rounds

  /// Answers under slack to fit from. Measured: "Slack and starts" (1 to 4).
  static constexpr std::size_t kStarts = 3;
  /// Greatest change that further ones are solved for first: shapes that may move by more do not
  /// always end with less. [cm] Chosen.
  static constexpr double kUsualChange = 1.0;
  /// Share of the greatest change that a seam takes up whose neighbours pull otherwise. Measured on
  /// 12 garments in 3 prints: 1.4 led to fits 1 to 2 % below 1.0 and 2.0.
  static constexpr double kTakenUp = 1.4;
  /// Rounds from one start, each with other seams pulling. Chosen.
  static constexpr int kMostRounds = 4;
  /// The same, once it has failed by no more than this share of what a seam may miss by. Chosen.
  static constexpr int kMostRetried = 12;
  static constexpr double kFailedByLittle = 0.3;
  /// Factor of a seam's pull after each round that leaves it worse off, and all of them together at
  /// most; factor of its weight in the next search. Chosen.
  static constexpr double kPullGrowth = 4, kMostPull = 64, kWeightGrowth = 3;
  /// Reviews of settled shapes in all, of one start, and of the one that stays. Chosen.
  static constexpr int kMostReviews = 12, kReviewsOfOne = 2, kReviewsOfLast = 6;

  // --- what a seam has to be, as mean mismatches; life-of-a-print.md, section 8

  /// Mean that counts as met. [cm] Rule.
  static constexpr double kMet = 0.1;
  /// Difference of two means that nobody sees. [cm] Rule.
  static constexpr double kUnseen = 0.03;
  /// Mean beyond which a seam looks broken. [cm] Rule.
  static constexpr double kBroken = 1.0;
  /// Share of its mean that shaping leaves at most of a seam that is worth bending; of one that
  /// looks broken even so. Rule.
  static constexpr double kWorthwhile = 0.75, kWorthwhileBroken = 0.5;
  /// Movement that leaves a line as drafted, to the eye. [cm] Rule.
  static constexpr double kStraight = 0.1;
  /// Share of the greatest mean that alignments are held to, so that shaping may miss a little.
  /// Chosen.
  static constexpr double kLimitShare = 0.98;
  /// Factor of what exceeds the greatest mean where starts are compared. Chosen.
  static constexpr double kBeyondLimit = 8;

  // --- settling, once targets are fixed

  /// Steps before a remedy, and those of them before the shape is held. Chosen.
  static constexpr int kSettleSteps = 15, kHoldAfter = 1;
  /// Remedies before a part gives up its targets, and steps in all. Chosen.
  static constexpr int kMostRemedies = 4, kMostSettling = 200;
  /// Factor of the reach around what went wrong, after each remedy. Chosen.
  static constexpr double kRemedyReach = 0.6;
  /// Error of a sewn edge's length, at most: of seams with up to forty edges; as a share of a
  /// seam's tolerance, for all its edges; that only more steps are needed for. [cm, share, cm]
  /// Chosen.
  static constexpr double kLengthError = 5e-5, kSeamShare = 0.2, kAlmostKept = 2e-3;
  /// Share of its limits beyond which a shape is stiffened, and while it is held. Chosen.
  static constexpr double kStiffenFrom = 0.9, kStiffenHeld = 0.99;
  /// Factor of a bend's and of an unsewn edge's weight where they break a limit, times the square
  /// of the excess. Chosen.
  static constexpr double kBendGrowth = 1.5, kEdgeGrowth = 2;
  /// Factor of an unsewn edge's weight, at most. Chosen.
  static constexpr double kMostStiffened = 1e3;
  /// Weight that holds a shape in place, per cm2. Chosen.
  static constexpr double kHold = 5.0;
  /// What has gone wrong: a triangle's area, as a share of that at rest, and a sewn edge's length.
  /// [share, cm] Chosen.
  static constexpr double kSqueezed = 0.45, kMissedLength = 2e-3;
  /// Distance from such a fault within which vertices may move less. [cm] Chosen.
  static constexpr double kNearFault = 6.0;
};

}  // namespace seamwise
