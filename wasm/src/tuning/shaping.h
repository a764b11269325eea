#pragma once
#include <cstddef>

namespace seamwise {

/// Constants of shaping by method `best`: fitting, settling, and the rules for seams. *Measured*
/// names a section of docs/experiments.md. *Rule* marks a requirement for results, counted by
/// "Rules" of docs/benchmarks.md. *Chosen* values were compared with no others.
struct ShapingTuning {
  // --- weights of a part's energy: lengths in cm, energies per cm of outline

  /// Conformal energy, per cm2 of fabric. Chosen.
  static constexpr double kConformal = 0.3;
  /// Change of the outline's direction, per rad2 at a vertex; the same at a corner. Chosen.
  static constexpr double kBend = 12.0, kCornerBend = 4.0;
  /// Pull of the outline to its rest position, per cm2; of the interior, as a share of it. Chosen.
  static constexpr double kRestPull = 0.01, kInteriorPull = 1e-4;
  /// Change of an unsewn edge's length, per cm2. Chosen.
  static constexpr double kUnsewn = 20.0;
  /// Distance of an unsewn edge's vertices from its line, per cm2. Chosen.
  static constexpr double kLine = 2000.0;
  /// Augmented Lagrangian of the length of a sewn edge of 1 cm, per cm2. Shorter edges are
  /// proportionally stiffer, because the compliances of springs in series add up. Measured: with
  /// equal stiffness, a line of 0.1 cm edges needed 70 steps to its length instead of 20, and
  /// mostly was reset to rest earlier (princess dress, pmm). The value itself is chosen.
  static constexpr double kLengthPenalty = 2e4;
  /// Penalty of movement beyond a vertex's reach, per cm2. Pulls are about 1 per cm, so the excess
  /// is slight. Chosen.
  static constexpr double kReachPenalty = 4e3;

  // --- a Newton step

  /// Least area of a triangle after a step, as a share of its rest area. Chosen.
  static constexpr double kLeastArea = 0.33;
  /// Greatest length of a step; linearised lengths are invalid beyond it. [cm] Chosen.
  static constexpr double kLongestStep = 0.4;
  /// Share of a gap outside the piece that one side may close; two cannot cross. Chosen.
  static constexpr double kGapShare = 0.45;
  /// Straight distance, as a share of the way along the outline, below which two points face each
  /// other across a gap; at a mere bend of the line it is greater. Chosen.
  static constexpr double kGapDetour = 0.6;

  // --- targets

  /// Mismatch below which targets pull no harder, with weights 1/d. [cm] Chosen.
  static constexpr double kLeastDistance = 0.05;
  /// Pull of a gathered seam, which cannot match along all of it, over that of another. Chosen.
  static constexpr double kGatheredPull = 0.3;
  /// Greatest distance of a vertex from a kept line; the seam's mean then stays within 0.3 mm. [cm]
  /// Chosen.
  static constexpr double kLineReach = 0.02;
  /// Greatest change that shapes use; a greater one distorts outlines without a gain
  /// (docs/formats.md, maxChangeCm). [cm] Chosen.
  static constexpr double kMostReach = 2.0;
  /// Share of the greatest change that limits shapes, since the penalty allows an excess; share by
  /// which a finished shape may exceed it. Chosen.
  static constexpr double kReachShare = 0.985, kReachExcess = 0.012;

  // --- steps of fitting: total number, and number from each start

  /// Steps on the original mesh. Measured: "Coarse to fine" (7, 2).
  static constexpr int kSteps = 7, kTrialSteps = 2;
  /// Steps on the coarser mesh. Measured: "Coarse to fine" (10, with 3 trial steps; 5 are chosen).
  static constexpr int kCoarseSteps = 10, kCoarseTrialSteps = 5;
  /// Steps on the original mesh after coarse ones. Measured: "Coarse to fine" (1, 2, 3).
  static constexpr int kFineSteps = 2;
  /// Additional steps of this kind if pieces had to be realigned. Chosen.
  static constexpr int kMoreFineSteps = 3;
  /// Greatest edge of the coarser mesh's outlines. [cm] Measured: "Coarse to fine" (2.1, 3.2).
  static constexpr double kCoarseEdge = 2.1;
  /// Sweeps that carry moves inwards from the outline; the next step balances the interior. Chosen.
  static constexpr int kProlongSweeps = 4;
  /// Steps between new joins and alignments. Measured: "Coarse to fine" (2, 3).
  static constexpr int kRealignEvery = 3;
  /// Newton steps of that alignment. Chosen.
  static constexpr int kRealignIterations = 2;
  /// Steps after which the mismatch of placing alone also limits seams that pull: by then, shaping
  /// has improved them as far as it can. Chosen.
  static constexpr int kLimitedFrom = 6;

  /// Last steps, in which seams that nearly match pull more and lost ones less; factor and its
  /// inverse. Measured: "Near matches" (6, 4 and 3 steps; 3, 6).
  static constexpr int kFavouredSteps = 4;
  static constexpr double kFavour = 3;
  /// Share of a seam's length that is off, below which it nearly matches, and above which it is
  /// lost. Measured: "Near matches" (0.4, 0.55; 0.5, 0.6).
  static constexpr double kNearShare = 0.4, kLostShare = 0.6;

  // --- starts and rounds

  /// Number of answers under slack to start fitting from. Measured: "Slack and starts" (1 to 4).
  static constexpr std::size_t kStarts = 3;
  /// A greater maximum change is solved with this one first: shapes that may move further do not
  /// always end with less mismatch. [cm] Chosen.
  static constexpr double kUsualChange = 1.0;
  /// Least share of the greatest change in rounds that follow where no shape was found. Chosen.
  static constexpr double kLeastHalved = 0.25;
  /// Mismatch, over the greatest change, that a seam can remove if its neighbours pull otherwise.
  /// Measured on 12 garments in 3 prints: mismatches at 1.4 were 1 to 2 % below those at 1.0
  /// and 2.0.
  static constexpr double kTakenUp = 1.4;
  /// Greatest number of rounds from one start, each with other pulling seams. Chosen.
  static constexpr int kMostRounds = 4;
  /// The same for a start that failed by at most this share of a seam's allowed mismatch. Chosen.
  static constexpr int kMostRetried = 12;
  static constexpr double kFailedByLittle = 0.3;
  /// Factor of a seam's pull after each round that worsens it, and limit of the product of these
  /// factors; factor of its weight in the next search. Chosen.
  static constexpr double kPullGrowth = 4, kMostPull = 64, kWeightGrowth = 3;
  /// Reviews of settled shapes in total, of one start, and of the final one. Chosen.
  static constexpr int kMostReviews = 12, kReviewsOfOne = 2, kReviewsOfLast = 6;

  // --- rules for a seam, as mean mismatches; life-of-a-print.md, section 8

  /// Greatest mean of a seam that counts as matched. [cm] Rule.
  static constexpr double kMet = 0.1;
  /// Greatest invisible difference of two means. [cm] Rule.
  static constexpr double kUnseen = 0.03;
  /// Mean above which a seam looks broken. [cm] Rule.
  static constexpr double kBroken = 1.0;
  /// Greatest share of its mean that remains if bending a seam pays off, and the same for a seam
  /// that still looks broken. Rule.
  static constexpr double kWorthwhile = 0.75, kWorthwhileBroken = 0.5;
  /// The first of both if seams count by their visibility. Rule.
  static constexpr double kWorthwhileSeen = 0.85;
  /// Mean by placing alone above which a seam is lost anyway, so that shaping may worsen it, if
  /// seams count by their visibility. [cm] Rule.
  static constexpr double kLost = 0.5;
  /// Least visibility of a seam that is seen at first sight. Rule.
  static constexpr double kVisible = 1.5;
  /// Greatest movement of a line that still looks as drafted. [cm] Rule.
  static constexpr double kStraight = 0.1;
  /// Share of the greatest mean that limits alignments, so that shaping has some tolerance. Chosen.
  static constexpr double kLimitShare = 0.98;
  /// Factor of the excess over the greatest mean in the comparison of starts. Chosen.
  static constexpr double kBeyondLimit = 8;

  // --- comparison of answers, if seams count by their visibility

  /// Greatest mismatch that is not seen. [cm] Rule.
  static constexpr double kSeen = 0.3;
  /// Share of a seam's length that is off at which it no longer counts as matched. Chosen.
  static constexpr double kUnmatchedShare = 0.2;
  /// Cost of a seam that does not match, per cm of its length. [cm]
  static constexpr double kUnmatchedCost = 1.0;
  /// Weight of the mismatch of a gathered seam. Chosen.
  static constexpr double kGatheredCost = 0.1;

  // --- settling, once targets are fixed

  /// Steps before a remedy, and steps before the shape is held. Chosen.
  static constexpr int kSettleSteps = 15, kHoldAfter = 1;
  /// Remedies before a part drops its targets, and greatest total number of steps. Chosen.
  static constexpr int kMostRemedies = 4, kMostSettling = 200;
  /// Factor of the reach around a fault, after each remedy. Chosen.
  static constexpr double kRemedyReach = 0.6;
  /// Greatest error of a sewn edge's length: for seams with up to forty edges; as a share of a
  /// seam's tolerance, for all its edges; up to which more steps suffice. [cm, share, cm] Chosen.
  static constexpr double kLengthError = 5e-5, kSeamShare = 0.2, kAlmostKept = 2e-3;
  /// Share of its limits above which a shape is stiffened, and the same while it is held. Chosen.
  static constexpr double kStiffenFrom = 0.9, kStiffenHeld = 0.99;
  /// Factors of the weights of a bend and of an unsewn edge that exceed a limit, times the square
  /// of the excess. Chosen.
  static constexpr double kBendGrowth = 1.5, kEdgeGrowth = 2;
  /// Greatest factor of an unsewn edge's weight. Chosen.
  static constexpr double kMostStiffened = 1e3;
  /// Weight that holds a shape in place, per cm2. Chosen.
  static constexpr double kHold = 5.0;
  /// Limits of a fault: a triangle's area, as a share of its rest area, and the error of a sewn
  /// edge's length. [share, cm] Chosen.
  static constexpr double kSqueezed = 0.45, kMissedLength = 2e-3;
  /// Distance from such a fault within which vertices may move less. [cm] Chosen.
  static constexpr double kNearFault = 6.0;
};

}  // namespace seamwise
