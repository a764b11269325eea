#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "base/outcome.h"
#include "geometry/vec2.h"
#include "photo/base/lattice_map.h"
#include "photo/base/lattice_reading.h"

namespace seamwise {

/// Known properties of a camera, and known lengths on the fabric.
struct MetricHints {
  /// Focal length on 35 mm film; the longer side of 36 mm is that of the uncropped image. [mm]
  std::optional<double> f35;
  /// Lengths of w1 and of w2, measured on the fabric. [cm]
  std::array<std::optional<double>, 2> lengths;
  /// Two points of the whole image and their distance on the fabric. [px], [cm]
  struct Span {
    Vec2 from = Vec2::Zero(), to = Vec2::Zero();
    double length = 0;
  };
  std::optional<Span> span;
};

enum class MetricSource : std::uint8_t {
  kScan,         ///< no perspective: pixels are lengths
  kFocalLength,  ///< stored in the file
  kAssumedFocalLength,
  kTwoLengths,
};

/// Lengths of w1 and w2, and the angle between them.
struct MetricReading {
  /// [w1.w1, w1.w2; w2.w1, w2.w2] in cm2; area 1 without a scale.
  Mat2 gram = Mat2::Identity();
  bool scaled = false;
  MetricSource source = MetricSource::kScan;
  /// Direction of a single measured length, in w1 and w2; zero if no length or both were measured.
  Vec2 along = Vec2::Zero();
  /// Standard errors: of |w2| / |w1|, as a share; of the angle [rad]; of lengths, as a share, 0
  /// without a scale.
  double aspect_error = 0, angle_error = 0, length_error = 0;

  /// Returns the Gram matrix for another basis, whose vectors are the columns of m in w1, w2.
  Mat2 rebased(const Mat2& m) const { return m.transpose() * gram * m; }
};

/// Measures a lattice's cell. The map's homography and the camera give G = M^T K^-T K^-1 M up to
/// scale, M being its first two columns [Zhang 2000]. Known lengths give the scale.
/// @param width, height   of the whole image. [px]
/// Errors: kOptions, one sentence, for an impossible hint.
Outcome<MetricReading> readMetric(const LatticeReading& reading, int width, int height,
                                  const MetricHints& hints);

/// Returns w1 and w2 in a print's orientation: w2 counter-clockwise, +y the warp.
/// The warp is assumed to run upwards at the image's middle, and exactly along or across the
/// lattice direction that is closest to an edge of the image. Lattice directions are w1 and w2, the
/// diagonals instead if both are equally long, and all three shortest ones of a hexagonal lattice.
/// @param map      map in this basis
/// @param gram     Gram matrix in this basis
std::array<Vec2, 2> placedLattice(const LatticeMap& map, const Mat2& gram);

}  // namespace seamwise
