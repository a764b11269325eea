#pragma once

namespace seamwise {

/// A closed interval.
struct Range {
  double least = 0, most = 0;
  constexpr bool holds(double value) const { return value >= least && value <= most; }  ///< not NaN
};

// Ranges of the options. web/src/model/base/core-tables.ts contains the same numbers, generated
// from here.
inline constexpr Range kMaxChangeCm{0, 50};
inline constexpr Range kEdgeLengthCm{0.1, 1.05};  ///< coarser edges hide mismatch
inline constexpr Range kAlpha{1e-9, 1e9};
inline constexpr Range kEffort{1, 64};
inline constexpr Range kStarts{1, 1000};
inline constexpr Range kProof{0, 1e6};
inline constexpr Range kToleranceDeg{0, 90};
inline constexpr Range kSeamWeight{0, 1e6};

}  // namespace seamwise
