#pragma once
#include <cstddef>

#include "geometry/vec2.h"

namespace seamwise {

/// Greatest residual at which pieces count as mirror images. [cm] Chosen, not measured.
inline constexpr double kMirrorTolerance = 0.1;

/// Constants by which symmetries are found, registered and made exact; chosen, not measured.
struct SymmetryTuning {
  // --- mirror maps of two outlines, by iterative closest points [Besl & McKay 1992]

  /// Distance of an outline's samples on straight runs, at most; curves have more. [cm]
  static constexpr double kSampleSpacing = 2.0;
  /// Starts of one search, at most: a circle has a mirror in every direction.
  static constexpr std::size_t kMostStarts = 8;
  /// Iterations at most, of outlines and of single edges.
  static constexpr int kMostIterations = 60, kMostEdgeIterations = 50;
  /// Ratio of the root mean squares of two iterations, above the tolerance, that ends them.
  static constexpr double kStalled = 0.99;
  /// A start is judged by every fourth sample, or by so many, and is hopeless where their root mean
  /// square is more than so many times the residual that is wanted.
  static constexpr std::size_t kTrialStride = 4, kTrialSamples = 500;
  static constexpr double kPruned = 5;
  /// Samples, and corners, that a map is settled on where there are twice as many and more.
  static constexpr std::size_t kSettlingSamples = 500;
  /// Points that an edge is registered by; points of each of a piece's curves that tell how far two
  /// of them are from mirror images.
  static constexpr int kEdgeSamples = 32, kCurveSamples = 8;

  // --- what a click means

  /// How far a clicked axis may be off: its direction, and its middle. [rad, cm]
  static constexpr double kClickTurn = 5 * kPi / 180, kClickShift = 1.0;
  /// How far two clicked edges may be from each other's images. [cm]
  static constexpr double kEdgesMeet = 2 * kMirrorTolerance;

  // --- symmetries of a whole garment

  /// Maps that a solution may begin with.
  static constexpr int kFirstChoices = 12;
  /// How far pieces may be from symmetric places around the body, where they hang by eye. [cm]
  static constexpr double kPlacementSlack = 5.0;
  /// How far the image of a seam may miss the other seam: at most, and as a share of its length;
  /// one that runs the other way misses by a quarter. [cm, share]
  static constexpr double kSeamSlack = 0.5, kSeamSlackShare = 0.2;
  /// Disagreement of grain lines at right angles, which decides only where places do not. [cm]
  static constexpr double kGrainWeight = 0.01;
  /// Difference of mapped lengths, as a share, that counts.
  static constexpr double kNoticeable = 0.01;

  // --- what symmetries may ask of the drafted outlines, well inside what a finished shape may
  // change

  /// How far the sides of a whole seam may miss their length ratio. [cm]
  static constexpr double kRatioError = 4e-3;
  /// Change of a sewn edge, as a share of its length; of a seam's side, as a share of its length or
  /// of 10 cm.
  static constexpr double kEdgeChange = 0.08, kSeamChange = 0.01;
  /// Distance of a vertex from its image. [cm]
  static constexpr double kImageOffset = 0.3;
  /// Share of the greatest change that making outlines exactly symmetric may take.
  static constexpr double kEvenedShare = 0.98;
  /// Share of kSeamTolerance that lengths may be off by then.
  static constexpr double kEvenedSeamShare = 0.9;
  /// Movement that has to be left for lengths to settle. [cm]
  static constexpr double kSettlingReach = 0.1;
  /// Edge length, as a share of what was asked for, below which sampling gets no finer.
  static constexpr double kFinestShare = 0.3;
};

}  // namespace seamwise
