#pragma once

namespace seamwise {

/// Constants for finding a cell's wallpaper group. Shares refer to the pattern's energy without
/// mean and noise.
struct GroupReadingTuning {
  // --- comparison

  /// Width of the Gaussian that softens cells, as a share of the root of the cell's area. Two
  /// samples of 128 hide the difference between kinds of blur.
  static constexpr double kSoftening = 0.009;
  /// Displacement of a cell by creases, as a share of the root of its area.
  static constexpr double kDisplacement = 0.004;
  /// Remaining displacement after the registration of each position.
  static constexpr double kLeftDisplacement = 0.0015;
  /// Remaining amplitude of light, colour and sampling, as a share of the pattern's.
  static constexpr double kLeftAmplitude = 0.02;
  /// Number of positions along a side that are searched for breaks.
  static constexpr int kPlaces = 24;

  // --- tolerances of a group

  /// Greatest share of energy, and greatest share at the worst position, of a present symmetry.
  static constexpr double kHasShare = 0.015, kHasWorst = 0.45;
  /// Least shares of an absent symmetry.
  static constexpr double kHasNotShare = 0.06, kHasNotWorst = 0.8;
  /// Share of energy that may vary along a stripe.
  static constexpr double kStripeShare = 0.01;
  /// Energy, in units of the noise, below which there is no print.
  static constexpr double kPlainEnergy = 3;
};

}  // namespace seamwise
