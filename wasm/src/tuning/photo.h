#pragma once

namespace seamwise {

/// Constants for reading a print from a photo as a whole.
struct PhotoTuning {
  /// Samples along a cell's side for its symmetries; no prime factor is above 5.
  static constexpr int kSamples = 120;
  /// Samples of the image per step of some milliseconds.
  static constexpr int kSamplesAtOnce = 200000;
  /// Greatest shift of the copies, as a share of the repeat; a greater one blurs their mean.
  static constexpr double kUneven = 0.025;
  /// Tolerance of the comparison of a lattice's shape with those of groups: number of standard
  /// errors, and least tolerance. [share, rad]
  static constexpr double kErrors = 3, kLeastTolerance = 0.01;
  /// Least tolerance if both vectors were measured on the fabric, as in
  /// web/src/model/print/repeat.ts.
  static constexpr double kMeasured = 0.005;
  /// Error of the proportions that is visible on fabric. [share]
  static constexpr double kWorthSaying = 0.005;
  /// Error of |w2| / |w1| in a photo of creased fabric, and in one of an unknown camera. [share]
  static constexpr double kCreased = 0.03, kAnyCamera = 0.15;
  /// Arbitrary repeat along a stripe: in cm for prints with a known scale; otherwise as a share of
  /// the stripe's width.
  static constexpr double kAlongStripe = 0.5, kStripeSide = 0.5;
  /// Greatest side of a tile. [px]
  static constexpr int kLongestTile = 2048;
  /// Samples of a tile per pixel of the image, along a line, and number of samples of all copies
  /// above which this density decreases for speed. A density of 2 reduces the error of drawn scans
  /// by 1.1 to 1.7 dB and suffices if the next sampling, on screen, is bilinear.
  static constexpr double kDenser = 2, kDenseSamples = 4e6;
  /// Shares of the time for an image of 12 million pixels.
  static constexpr double kSearchShare = 0.6, kFieldsShare = 0.25, kMeanShare = 0.1,
                          kGroupsShare = 0.05;
};

}  // namespace seamwise
