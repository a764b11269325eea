#pragma once

namespace seamwise {

/// Budgets of a marker's stages in table reads. Each stage takes about half a second of one core in
/// WebAssembly for a dozen pieces. Costs were measured on five garments.
struct MarkerTuning {
  // --- at effort 1

  static constexpr double kLayReads = 1e9;
  static constexpr double kWidthReads = 1e8;  ///< budget for one other fabric width
  static constexpr double kProofRows = 4e8;   ///< rows of dots visited by proofs

  // --- cost of other work

  static constexpr double kReadsOfRow = 5;       ///< a row of dots visited by a proof
  static constexpr double kReadsOfDot = 60;      ///< computing a table's dot
  static constexpr double kReadsOfTable = 5e5;   ///< computing a table, apart from its dots
  static constexpr double kReadsOfShapes = 2e7;  ///< computing all shapes of a board
};

}  // namespace seamwise
