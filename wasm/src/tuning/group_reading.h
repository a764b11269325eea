#pragma once

namespace seamwise {

/// Constants by which a cell's wallpaper group is read. Shares are of the pattern's energy, its
/// mean and noise taken away.
struct GroupReadingTuning {
  // --- what is compared

  /// Width of the Gaussian that cells are softened by, as a share of the root of the cell's area:
  /// two samples of 128 hide what differs between one kind of blur and another.
  static constexpr double kSoftening = 0.009;
  /// Displacement that creases leave in a cell, as a share of the root of its area.
  static constexpr double kDisplacement = 0.004;
  /// Part of it that is left once each place is registered.
  static constexpr double kLeftDisplacement = 0.0015;
  /// Amplitude that light, colour and sampling leave, as a share of the pattern's.
  static constexpr double kLeftAmplitude = 0.02;
  /// Places along a side at which breaks are looked for.
  static constexpr int kPlaces = 24;

  // --- what a group may miss by

  /// Share of energy, and share at the worst place, up to which a symmetry is there.
  static constexpr double kHasShare = 0.015, kHasWorst = 0.45;
  /// The same from which it is not.
  static constexpr double kHasNotShare = 0.06, kHasNotWorst = 0.8;
  /// Share of energy that may vary along a stripe.
  static constexpr double kStripeShare = 0.01;
  /// Energy, in units of the noise, below which there is no print.
  static constexpr double kPlainEnergy = 3;
};

}  // namespace seamwise
