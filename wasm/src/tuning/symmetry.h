#pragma once
#include <cstddef>

#include "geometry/vec2.h"

namespace seamwise {

/// Greatest residual at which pieces count as mirror images. [cm] Chosen, not measured.
inline constexpr double kMirrorTolerance = 0.1;

/// Constants of detecting, registering and enforcing symmetries; chosen, not measured.
struct SymmetryTuning {
  // --- mirror maps of two outlines, by iterative closest points [Besl & McKay 1992]

  /// Greatest distance of an outline's samples on straight parts; curves have more samples. [cm]
  static constexpr double kSampleSpacing = 2.0;
  /// Greatest number of starts of one search; a circle has a mirror in every direction.
  static constexpr std::size_t kMostStarts = 8;
  /// Greatest number of iterations for outlines and for single edges.
  static constexpr int kMostIterations = 60, kMostEdgeIterations = 50;
  /// Ratio of the root mean squares of two iterations that ends them above the tolerance.
  static constexpr double kStalled = 0.99;
  /// A trial of a start uses every fourth sample, or about kTrialSamples of very many. The start is
  /// dropped if their root mean square is more than kPruned times the wanted residual.
  static constexpr std::size_t kTrialStride = 4, kTrialSamples = 500;
  static constexpr double kPruned = 5;
  /// Number of samples, and of corners, for settling a map if there are at least twice as many.
  static constexpr std::size_t kSettlingSamples = 500;
  /// Number of points for registering an edge, and of points per curve for measuring the deviation
  /// of two curves from mirror images.
  static constexpr int kEdgeSamples = 32, kCurveSamples = 8;

  // --- tolerances of clicks

  /// Greatest error of a clicked axis: of its direction, and of its middle. [rad, cm]
  static constexpr double kClickTurn = 5 * kPi / 180, kClickShift = 1.0;
  /// Greatest distance of two clicked edges from each other's images. [cm]
  static constexpr double kEdgesMeet = 2 * kMirrorTolerance;

  // --- symmetries of a whole garment

  /// Number of maps tried as the start of a solution.
  static constexpr int kFirstChoices = 12;
  /// Greatest distance of pieces from symmetric positions around the body, which are placed by eye.
  /// [cm]
  static constexpr double kPlacementSlack = 5.0;
  /// Greatest distance between the image of a seam and the other seam, absolute and as a share of
  /// its length. The distance of a reversed seam is a quarter of its length. [cm, share]
  static constexpr double kSeamSlack = 0.5, kSeamSlackShare = 0.2;
  /// Disagreement of perpendicular grain lines, which decides only between equal placements. [cm]
  static constexpr double kGrainWeight = 0.01;
  /// Least relative difference of mapped lengths that counts.
  static constexpr double kNoticeable = 0.01;

  // --- limits on changes of the drafted outlines by symmetries, well inside those of a finished
  // shape

  /// Greatest deviation of the sides of a whole seam from their length ratio. [cm]
  static constexpr double kRatioError = 4e-3;
  /// Change of a sewn edge, as a share of its length; of a seam's side, as a share of its length or
  /// of 10 cm.
  static constexpr double kEdgeChange = 0.08, kSeamChange = 0.01;
  /// Distance of a vertex from its image. [cm]
  static constexpr double kImageOffset = 0.3;
  /// Share of the greatest change that exactly symmetric outlines may need.
  static constexpr double kEvenedShare = 0.98;
  /// Greatest error of lengths in exactly symmetric outlines, as a share of kSeamTolerance.
  static constexpr double kEvenedSeamShare = 0.9;
  /// Movement that must remain for settling lengths. [cm]
  static constexpr double kSettlingReach = 0.1;
  /// Least edge length of a finer sampling, as a share of the requested one.
  static constexpr double kFinestShare = 0.3;
};

}  // namespace seamwise
