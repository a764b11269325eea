#pragma once

namespace seamwise {

/// Shares of the time of a solve that its stages take as a rule: progress is reported by them, and
/// results do not depend on them. Measured: docs/benchmarks.md, "Ratios", distance of the progress
/// from the share of time, which they keep below 0.2.
struct ProgressTuning {
  /// Progress once a garment has been read and meshed, and the share of that for reading.
  static constexpr double kPrepared = 0.15, kReading = 0.7;
  /// Progress of meshing when symmetries are reconciled, and when outlines are sampled; share of it
  /// for more symmetry than is asked for, which may be in vain.
  static constexpr double kReconciled = 0.2, kSampled = 0.25, kMoreSymmetry = 0.9;
  /// Progress when fitting has ended.
  static constexpr double kFitted = 0.95;
  /// Progress after the search and after setting up where the print meets as the pieces lie.
  static constexpr double kPerfectlySearched = 0.72, kPerfectlySetUp = 0.86;
  /// Shares of the searches' time of the symmetric garment, of that at rest, and under slack: with
  /// a symmetric answer first, and without.
  struct Searches {
    double guide, rest, slack;
  };
  static constexpr Searches kGuided{0.22, 0.45, 0.33}, kUnguided{0, 0.62, 0.38};
  /// The same of a search with other weights or pins, and of one with the print turned.
  static constexpr double kNearby = 0.15, kTouchUp = 0.04;
  /// Share of a search's time before its proof.
  static constexpr double kBeforeProof = 0.6;

  /// Share of all searches: the more there are pieces to place and symmetries to try, the more.
  static constexpr double searches(double pieces, double symmetries) {
    return 0.85 - 0.42 / (1 + pieces / 8) * (0.85 + 0.6 / symmetries);
  }
};

}  // namespace seamwise
