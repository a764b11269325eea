#pragma once

namespace seamwise {

/// Usual shares of a solve's time per stage, for progress reports. Results do not depend on them.
/// Measured: docs/benchmarks.md, "Ratios"; the difference between progress and share of time stays
/// below 0.2.
struct ProgressTuning {
  /// Progress after a garment is read and meshed, and the share of reading in it.
  static constexpr double kPrepared = 0.15, kReading = 0.7;
  /// Progress of meshing after symmetries are reconciled, and after outlines are sampled; share of
  /// the attempt with more symmetries than requested, which may fail.
  static constexpr double kReconciled = 0.2, kSampled = 0.25, kMoreSymmetry = 0.9;
  /// Progress after fitting.
  static constexpr double kFitted = 0.95;
  /// Progress after the search and after setup if the print matches without shaping.
  static constexpr double kPerfectlySearched = 0.72, kPerfectlySetUp = 0.86;
  /// Shares of the searches' time for the symmetric garment (`guide`), at rest and under slack:
  /// with a symmetric answer first, and without one.
  struct Searches {
    double guide, rest, slack;
  };
  static constexpr Searches kGuided{0.22, 0.45, 0.33}, kUnguided{0, 0.62, 0.38};
  /// Shares of a search with other weights or pins, and of one with only the print rotated.
  static constexpr double kNearby = 0.15, kTouchUp = 0.04;
  /// Share of a search's time before its proof.
  static constexpr double kBeforeProof = 0.6;

  /// Share of all searches, which grows with the number of pieces and of symmetries.
  static constexpr double searches(double pieces, double symmetries) {
    return 0.85 - 0.42 / (1 + pieces / 8) * (0.85 + 0.6 / symmetries);
  }
};

}  // namespace seamwise
