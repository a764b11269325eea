#pragma once

namespace seamwise {

/// How long pieces are laid on cloth, in reads of tables. Budgets are chosen so that each stage
/// takes about half a second of one core in WebAssembly for a dozen pieces; costs were measured on
/// five garments.
struct NestingTuning {
  // --- at effort 1

  static constexpr double kLayReads = 1e9;
  static constexpr double kWidthReads = 1e8;  ///< on cloth of one other width
  static constexpr double kProofRows = 4e8;   ///< rows of dots that proofs look at

  // --- what else takes time

  static constexpr double kReadsOfRow = 5;       ///< a row of dots that a proof looks at
  static constexpr double kReadsOfDot = 60;      ///< making a table's dot
  static constexpr double kReadsOfTable = 5e5;   ///< making a table, beside its dots
  static constexpr double kReadsOfShapes = 2e7;  ///< making all shapes of a board
};

}  // namespace seamwise
