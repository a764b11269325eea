#pragma once

namespace seamwise {

/// Constants of proofs, by elimination over the graph of seams, that an alignment is the best.
/// *Measured* names a section of docs/experiments.md; *chosen* were compared with no other values.
/// Work is counted in element distances.
struct ProofTuning {
  /// Share of its cost by which a proven answer may exceed the bound. Chosen;
  /// stated by docs/life-of-a-print.md, section 10.
  static constexpr double kProven = 1e-3;
  /// Unknowns up to which every search tries a proof. Chosen; "Proofs" tells what can be proven.
  static constexpr int kProvable = 5;
  /// Work for it, as a share of the search's distances. Chosen.
  static constexpr double kWorkShare = 0.03;
  /// Distances of a search that take as long as one of a proof. Chosen.
  static constexpr double kDistanceWork = 5;
  /// Distances that take as long as one sum of costs while eliminating is 1 / this. Chosen.
  static constexpr double kSumWork = 0.1;
  /// Distances of one step: about a millisecond. Chosen.
  static constexpr double kStepWork = 3e5;
  /// Share of the work that goes into better answers. Chosen.
  static constexpr double kDescentShare = 0.1;
  /// Newton steps of each of them, at most. Chosen.
  static constexpr int kDescentIterations = 12;
  /// Memory of all tables. [bytes] Measured: "Proofs" (marked *full*).
  static constexpr double kMemory = 160e6;
  /// Boxes that are halved: with bounds this share of the way from the least to the answer, or
  /// less. Measured: "Proofs" (no other share is better).
  static constexpr double kHalvedShare = 0.5;
  /// Spread of a group of samples, over how far its points move, up to which it counts as one
  /// sample. Chosen.
  static constexpr double kGroupSpread = 0.25;
};

}  // namespace seamwise
