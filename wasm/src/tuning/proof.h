#pragma once

namespace seamwise {

/// Constants of proofs, by elimination over the graph of seams, that an alignment is the best.
/// *Measured* names a section of docs/experiments.md. *Chosen* values were compared with no others.
/// Work is counted in element distances.
struct ProofTuning {
  /// Share of its cost by which a proven answer may exceed the bound. Chosen; documented in
  /// docs/life-of-a-print.md, section 10.
  static constexpr double kProven = 1e-3;
  /// Unknowns up to which every search tries a proof. Chosen; "Proofs" lists provable cases.
  static constexpr int kProvable = 5;
  /// Work for that proof, as a share of the search's distances. Chosen.
  static constexpr double kWorkShare = 0.03;
  /// Distances of a search that take as long as one of a proof. Chosen.
  static constexpr double kDistanceWork = 5;
  /// Distances that take as long as one sum of costs during elimination. Chosen.
  static constexpr double kSumWork = 0.1;
  /// Distances of one step of about a millisecond. Chosen.
  static constexpr double kStepWork = 3e5;
  /// Share of the work for better answers. Chosen.
  static constexpr double kDescentShare = 0.1;
  /// Greatest number of Newton steps for each of them. Chosen.
  static constexpr int kDescentIterations = 12;
  /// Memory of all tables. [bytes] Measured: "Proofs" (marked *full*).
  static constexpr double kMemory = 160e6;
  /// Boxes are halved if their bound is at most this share of the way from the least bound to the
  /// answer. Measured: "Proofs" (no other share is better).
  static constexpr double kHalvedShare = 0.5;
  /// Greatest spread of a group of samples that counts as one sample, over the movement of its
  /// points. Chosen.
  static constexpr double kGroupSpread = 0.25;
};

}  // namespace seamwise
