#include "photo/fabric/metric.h"

#include <algorithm>
#include <cmath>

#include "photo/base/map_inverse.h"

namespace seamwise {

namespace {

constexpr double kFilmSide = 36;      // longer side of 35 mm film. [mm]
constexpr double kUsualFocus = 0.75;  // usual of phones, relative to the longer side: 24 to 30 mm
constexpr double kUsualError = 0.3;   // relative error of it: 24 to 35 mm
/// Errors of the optical axis, relative to the longer side: of a whole image, and of one that may
/// be cropped.
constexpr double kFileMiddle = 0.005, kAnyMiddle = 0.1;
constexpr double kFileError = 0.02;  // relative error of f35, which has whole mm
/// An image has no perspective up to this change of scale from its middle to its border: kSurely
/// times the lattice's error, and at least the share kNoPerspective, a tilt of half a degree.
constexpr double kSurely = 4, kNoPerspective = 0.004;
constexpr double kPointing = 1;                            // error of a point set by the user. [px]
constexpr double kTape = 0.001;                            // error of a measured length, as a share
constexpr double kEqualSides = 0.01, kRightAngle = 0.02;   // a share; a cosine
constexpr double kShortestFocus = 0.3, kLongestFocus = 6;  // relative to the longer side
constexpr double kFocusStep = 1.078;                       // factor between tried focal lengths

double gramArea(const Mat2& gram) {
  return std::sqrt(std::max(gram(0, 0) * gram(1, 1) - gram(0, 1) * gram(0, 1), 1e-300));
}

/// Returns cosine and sine of the angle between w1 and w2.
Vec2 gramAngle(const Mat2& gram) { return Vec2(gram(0, 1), gramArea(gram)).normalized(); }

double gramAspect(const Mat2& gram) { return std::sqrt(gram(1, 1) / gram(0, 0)); }

/// Returns the absolute logarithm of the cell's aspect over `aspect`. Single precision adds less to
/// a module.
double aspectOff(const Mat2& gram, double aspect) {
  return std::abs(std::log(static_cast<float>(gramAspect(gram) / aspect)));
}

/// Returns the Gram matrix with area 1 for a camera of focal length f; 0 for a scan drops the third
/// row. [px]
Mat2 gramFor(const Mat3& h, const Vec2& middle, double f) {
  Eigen::Matrix<double, 3, 2> ray;
  for (int c = 0; c < 2; ++c) {
    ray(0, c) = h(0, c) - middle.x() * h(2, c);
    ray(1, c) = h(1, c) - middle.y() * h(2, c);
    ray(2, c) = f * h(2, c);
  }
  const Mat2 gram = ray.transpose() * ray;
  return gram / gramArea(gram);
}

/// Returns the change of scale from the middle to the border: the relative change of the map's
/// denominator over half the longer side.
double scaleChange(const LatticeMap& map, int longer) {
  const Vec2 u = MapInverse(map)(map.middle);
  const Mat3& h = map.homography;
  const double depth = h(2, 0) * u.x() + h(2, 1) * u.y() + h(2, 2);
  const Mat2 d = derivative(map, u);
  const double det = cross(d.col(0), d.col(1));
  const Vec2 slope(cross(Vec2(h(2, 0), h(2, 1)), Vec2(d(1, 0), d(1, 1))) / det,
                   cross(Vec2(d(0, 0), d(0, 1)), Vec2(h(2, 0), h(2, 1))) / det);
  return slope.norm() * longer / 2 / std::abs(depth);
}

/// Returns the tried focal length whose cell has sides closest to the measured ratio; `likely` if
/// none is closer.
double focusFor(const Mat3& h, const Vec2& middle, double longer, double likely, double aspect) {
  double best = likely, least = aspectOff(gramFor(h, middle, likely), aspect);
  for (double f = longer * kShortestFocus; f < longer * kLongestFocus; f *= kFocusStep) {
    const double off = aspectOff(gramFor(h, middle, f), aspect);
    if (off < least) least = off, best = f;
  }
  return best;
}

Error badHint(const char* message) {
  Error error;
  error.code = Failure::kOptions;
  error.message = message;
  return error;
}

void scaleMetric(double factor, double error, MetricReading* reading) {
  reading->gram *= factor * factor;
  reading->scaled = true;
  reading->length_error = error;
}

}  // namespace

Outcome<MetricReading> readMetric(const LatticeReading& reading, int width, int height,
                                  const MetricHints& hints) {
  const auto& [first, second] = hints.lengths;
  for (const std::optional<double>& length : hints.lengths)
    if (length && !(*length > 0 && *length < 1e4))
      return badHint("a measured repeat has to be longer than 0 cm and shorter than 100 m");
  if (hints.f35 && !(*hints.f35 > 3 && *hints.f35 < 3000))
    return badHint("a focal length on 35 mm film lies between 3 and 3000 mm; leave it out");
  const Mat3& h = reading.map.homography;
  const Vec2& middle = reading.map.middle;
  const double longer = std::max(width, height);
  MetricReading metric;
  double f = kUsualFocus * longer, f_error = kUsualError;
  if (hints.f35) {
    f = *hints.f35 / kFilmSide * longer, f_error = kFileError;
    metric.source = MetricSource::kFocalLength;
  } else if (scaleChange(reading.map, static_cast<int>(longer)) <
             std::max(kNoPerspective, kSurely * reading.uncertainty)) {
    f_error = 0;
  } else {
    metric.source = MetricSource::kAssumedFocalLength;
  }
  const bool scan = metric.source == MetricSource::kScan;
  if (first && second) {
    metric.source = MetricSource::kTwoLengths;
    if (!scan) f = focusFor(h, middle, longer, f, *second / *first);
  }
  // The third row of a scan is noise.
  metric.gram = gramFor(h, middle, scan ? 0 : f);
  double aspect_squares = 2 * reading.uncertainty * reading.uncertainty;
  double angle_squares = reading.uncertainty * reading.uncertainty;
  const auto vary = [&](const Vec2& off, double share) {
    const Mat2 other = gramFor(h, middle + longer * off, f * (1 + share));
    const double aspect = aspectOff(other, gramAspect(metric.gram));
    const double angle = cross(gramAngle(metric.gram), gramAngle(other));  // sine of a small angle
    aspect_squares += aspect * aspect;
    angle_squares += angle * angle;
  };
  if (!scan) {
    vary(Vec2::Zero(), -f_error);
    // An image without a focal length may be cropped.
    const double off = hints.f35 ? kFileMiddle : kAnyMiddle;
    vary(Vec2(off, 0), 0);
    vary(Vec2(0, off), 0);
  }
  metric.aspect_error = std::sqrt(aspect_squares);
  metric.angle_error = std::sqrt(angle_squares);
  if (first && second) {
    const double product = *first * *second * gramAngle(metric.gram).x();
    metric.gram << *first * *first, product, product, *second * *second;
    metric.aspect_error = kTape * std::sqrt(2.0);
    scaleMetric(1, kTape, &metric);
  } else if (first || second) {
    const int k = first ? 0 : 1;
    metric.along = Vec2::Unit(k);
    scaleMetric((first ? *first : *second) / std::sqrt(metric.gram(k, k)),
                Vec2(kTape, metric.aspect_error / 2).norm(), &metric);
  } else if (hints.span) {
    const MapInverse inverse(reading.map);
    const Vec2 u = inverse(hints.span->to) - inverse(hints.span->from);
    const double apart = std::sqrt(std::max(u.dot(metric.gram * u), 0.0));
    const double px = (hints.span->to - hints.span->from).norm();
    if (!(hints.span->length > 0 && hints.span->length < 1e4 && px > 4 * kPointing))
      return badHint(
          "two points on the photo have to lie more than 4 px apart, and their distance on the "
          "fabric between 0 cm and 100 m");
    metric.along = u;
    scaleMetric(hints.span->length / apart,
                Vec2(std::sqrt(2.0) * kPointing / px, metric.aspect_error / 2).norm(), &metric);
  }
  return metric;
}

std::array<Vec2, 2> placedLattice(const LatticeMap& map, const Mat2& gram) {
  const double along = std::sqrt(gram(0, 0)), area = gramArea(gram);
  Mat2 w;  // w1 and w2 as columns, w1 along x
  w << along, gram(0, 1) / along, 0, area / along;
  const Mat2 seen = derivative(map, MapInverse(map)(map.middle));
  const double det = cross(seen.col(0), seen.col(1));
  // Direction of the image's upward edge on the fabric, because y points down in the image. It is
  // rotated to y.
  const Vec2 up = (w * Vec2(seen(0, 1) / det, -seen(0, 0) / det)).normalized();
  const Mat2 upright = (Mat2() << up.y(), -up.x(), up.x(), up.y()).finished() * w;
  // Cosine and sine of the rotation to the nearest axis.
  Vec2 snap = Vec2::UnitX();
  double nearest = 1;
  const double longer = std::max(along, std::sqrt(gram(1, 1)));
  const bool rhombic = std::abs(gramAspect(gram) - 1) < kEqualSides;
  const double cosine = std::abs(gramAngle(gram).x());
  for (const Vec2& u : {Vec2(1, 0), Vec2(0, 1), Vec2(1, 1), Vec2(1, -1)}) {
    const bool diagonal = u.prod() != 0;
    if (rhombic && cosine > kRightAngle && std::abs(cosine - 0.5) > kRightAngle) {
      if (!diagonal) continue;  // the diagonals are the axes of the centred rectangle
    } else if (diagonal && (w * u).norm() > longer * (1 + kEqualSides) &&
               !(rhombic && cosine <= kRightAngle)) {
      continue;  // hexagons have six directions, squares four, rectangles two
    }
    Vec2 direction = (upright * u).normalized();
    if (std::abs(direction.y()) > std::abs(direction.x())) direction = perp(direction);
    const double off = std::abs(direction.y());
    if (off >= nearest - 1e-6) continue;
    nearest = off;
    snap = Vec2(std::abs(direction.x()), std::copysign(off, -direction.x() * direction.y()));
  }
  const Mat2 placed = (Mat2() << snap.x(), -snap.y(), snap.y(), snap.x()).finished() * upright;
  return {placed.col(0), placed.col(1)};
}

}  // namespace seamwise
