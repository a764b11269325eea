#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "base/outcome.h"
#include "geometry/vec2.h"
#include "recognition/base/lattice_map.h"
#include "recognition/base/lattice_reading.h"

namespace seamwise {

/// What is known of a camera and of lengths on the cloth.
struct MetricHints {
  /// Focal length on 35 mm film, its longer side of 36 mm being the picture's, which is whole. [mm]
  std::optional<double> f35;
  /// Lengths of w1 and of w2, measured on the cloth. [cm]
  std::array<std::optional<double>, 2> lengths;
  /// Two points of the whole picture and how far apart they lie on the cloth. [px], [cm]
  struct Span {
    Vec2 from = Vec2::Zero(), to = Vec2::Zero();
    double length = 0;
  };
  std::optional<Span> span;
};

enum class MetricSource : std::uint8_t {
  kScan,         ///< no perspective: pixels are lengths
  kFocalLength,  ///< the file's
  kAssumedFocalLength,
  kTwoLengths,
};

/// How long w1 and w2 are, and the angle between them.
struct MetricReading {
  /// [w1.w1, w1.w2; w2.w1, w2.w2] in cm2; until there is a scale, with area 1.
  Mat2 gram = Mat2::Identity();
  bool scaled = false;
  MetricSource source = MetricSource::kScan;
  /// What one length was measured along, in w1 and w2; zero where none was, or both w1 and w2 were.
  Vec2 along = Vec2::Zero();
  /// Standard errors: of |w2| / |w1|, as a share; of the angle [rad]; of lengths, as a share, but 0
  /// until there is a scale.
  double aspect_error = 0, angle_error = 0, length_error = 0;

  /// The same for another basis: its vectors are the columns of m in w1, w2.
  Mat2 rebased(const Mat2& m) const { return m.transpose() * gram * m; }
};

/// Measures a lattice's cell: from the map's homography and the camera, G = M^T K^-T K^-1 M up to
/// scale, M being its first two columns [Zhang 2000]; then from lengths.
/// Errors: kOptions, one sentence, when a hint cannot be.
/// @param width, height   of the whole picture. [px]
Outcome<MetricReading> readMetric(const LatticeReading& reading, int width, int height,
                                  const MetricHints& hints);

/// w1 and w2 as a print has them, w2 counter-clockwise, +y the warp. The warp is taken to run
/// upwards on the picture, at its middle, and exactly along or across that direction of the lattice
/// which lies nearest to one of the picture's edges: of w1 and w2, of the diagonals instead if both
/// are equally long, and of all three shortest ones of a hexagonal lattice.
/// @param map      of this basis
/// @param gram     of this basis
std::array<Vec2, 2> placedLattice(const LatticeMap& map, const Mat2& gram);

}  // namespace seamwise
