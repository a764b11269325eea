#pragma once

namespace seamwise {

/// How a print is read off a picture as a whole.
struct PhotoTuning {
  /// Of a cell's side, for its symmetries: no prime factor above 5.
  static constexpr int kSamples = 120;
  /// Samples of the picture at once, for steps of some milliseconds.
  static constexpr int kSamplesAtOnce = 200000;
  /// Of the shift of the copies, as a share of the repeat: beyond it the mean loses its detail.
  static constexpr double kUneven = 0.025;
  /// Of the lattice's shape when it is compared with those that groups have: standard errors, and
  /// at least so much. [share, rad]
  static constexpr double kErrors = 3, kLeastTolerance = 0.01;
  /// The same once both vectors were measured on the cloth, as web/src/model/repeat.ts has it.
  static constexpr double kMeasured = 0.005;
  /// A share of the proportions that a maker would see on cloth.
  static constexpr double kWorthSaying = 0.005;
  /// Of |w2| / |w1|: by which a photograph of creased cloth errs, and if its camera is unknown.
  /// [share]
  static constexpr double kCreased = 0.03, kAnyCamera = 0.15;
  /// Of a stripe, which is any length along itself, as prints have it [cm]; as a share of its
  /// width where nobody knows that.
  static constexpr double kAlongStripe = 0.5, kStripeSide = 0.5;
  /// Of a tile. [px]
  static constexpr int kLongestTile = 2048;
  /// Samples of it per pixel of the picture, along a line, while all copies take no more than so
  /// many: beyond, time counts more. Twice as many leave 1.1 to 1.7 dB less error of drawn scans,
  /// and are enough where the next sampling, on screen, is bilinear.
  static constexpr double kDenser = 2, kDenseSamples = 4e6;
  /// Shares of the time that a picture of 12 million pixels takes.
  static constexpr double kSearchShare = 0.6, kFieldsShare = 0.25, kMeanShare = 0.1,
                          kGroupsShare = 0.05;
};

}  // namespace seamwise
