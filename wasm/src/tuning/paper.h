#pragma once

namespace seamwise {

/// Constants of methods `paper` (Wolff et al. 2019) and `ws19`. The comments name the paper's
/// formulas. The paper gives none of these numbers, so all others are chosen, not measured.
struct PaperTuning {
  // --- local sweeps (paper, Sec. 3.1 and Eq. 1)

  /// Change of a sweep below which it has converged. [rad or cm]
  static constexpr double kSweepStill = 1e-5;
  /// Greatest number of sweeps of each kind.
  static constexpr int kMostSweeps = 300;
  /// Difference of turns up to which elements compete by distance. [rad]
  static constexpr double kSameTurn = 0.1;

  // --- E_prox + alpha E_conf + beta E_flip + gamma (E_match + E_sym) (paper, Eq. 8)

  /// beta.
  static constexpr double kFlipWeight = 0.01;
  /// s of E_flip: share of the rest area at which the barrier starts (Schueller et al. 2013).
  static constexpr double kFlipStart = 0.5;
  /// gamma doubles from 1 up to this value (paper: it grows).
  static constexpr double kMostGamma = 1e12;
  /// Greatest number of Newton steps under one gamma.
  static constexpr int kMostNewton = 60;
  /// Movement of a step that ends a gamma. [cm]
  static constexpr double kNewtonStill = 1e-5;
  /// E_match and E_sym per vertex below which the deformation ends. [cm2]
  static constexpr double kSatisfied = 1e-6;
  /// Errors below which it ends: of the two sides of a whole seam, inside kSeamTolerance, and of a
  /// vertex and its image. [cm]
  static constexpr double kSeamError = 8e-3, kMirrorError = 8e-4;

  // --- attempts, until the greatest change holds

  /// alpha doubles from 1 up to this value.
  static constexpr double kMostAlpha = 65536;
  /// Movement, over the greatest change, beyond which an attempt has failed.
  static constexpr double kLost = 3;
  /// Least share of the way to their targets that seams move; the share is halved from 1.
  static constexpr double kLeastDraw = 1.0 / 32;
  /// Distance of clipped targets, over the greatest change.
  static constexpr double kClip = 0.9;
};

}  // namespace seamwise
