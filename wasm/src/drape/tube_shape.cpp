// Construction of a tube from its sections; tube.cpp computes distances from it.
#include <algorithm>
#include <cmath>
#include <utility>

#include "drape/tube.h"
#include "drape/turn.h"

namespace seamwise {
namespace {

constexpr int kCorners = 96;
constexpr double kBetweenSections = 1;  ///< cm, margin for splines wider than sections

// Returns the second derivatives of the natural cubic spline through the values, by tridiagonal
// elimination.
std::vector<double> splineBends(const std::vector<double>& x, const std::vector<double>& y) {
  const std::size_t n = x.size();
  std::vector<double> bend(n, 0.0), upper(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double before = x[i] - x[i - 1], after = x[i + 1] - x[i];
    const double jump = (y[i + 1] - y[i]) / after - (y[i] - y[i - 1]) / before;
    const double pivot = 2 * (before + after) - before * upper[i - 1];
    upper[i] = after / pivot;
    bend[i] = (6 * jump - before * bend[i - 1]) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 1;) bend[i] -= upper[i] * bend[i + 1];
  return bend;
}

}  // namespace

std::vector<Vec2> Section::polygon() const {
  std::vector<Vec2> corners;
  for (int k = 0; k < kCorners; ++k) {
    const Turn turn = turnOfDegrees(k * (360.0 / kCorners));
    const double cc = turn.cosine * turn.cosine, ss = turn.sine * turn.sine;
    const double r = std::sqrt(2 / (1 + std::sqrt(1 + 4 * square * cc * ss)));
    corners.push_back({r * turn.sine * width, middle + r * turn.cosine * depth});
  }
  return corners;
}

double Section::girth() const {
  const std::vector<Vec2> corners = polygon();
  double sum = 0;
  for (int k = 0; k < kCorners; ++k)
    sum += planarLength(Vec2(corners[(k + 1) % kCorners] - corners[k]));
  return sum;
}

Section Section::withGirth(double girth_cm) const {
  const double scale = girth_cm / girth();
  Section scaled = *this;
  scaled.width *= scale;
  scaled.depth *= scale;
  return scaled;
}

Tube::Tube(Axis axis, const std::vector<Section>& sections, TubeEnd bottom, TubeEnd top)
    : axis_(std::move(axis)), bottom_(bottom), top_(top) {
  for (const Section& s : sections) {
    levels_.push_back(s.level);
    values_[kWidth].push_back(s.width);
    values_[kDepth].push_back(s.depth);
    values_[kMiddle].push_back(s.middle);
    values_[kSquare].push_back(s.square);
  }
  for (int shape = 0; shape < kShapes; ++shape)
    bends_[shape] = splineBends(levels_, values_[shape]);
  low_ = {0, 1e9, bottom.level}, high_ = {0, -1e9, top.level};
  for (const Section& s : sections) {
    high_[0] = std::max(high_[0], s.width);
    low_[1] = std::min(low_[1], s.middle - s.depth),
    high_[1] = std::max(high_[1], s.middle + s.depth);
  }
  // Splines overshoot slightly between their sections, and so do sections with a negative square.
  low_[0] = -high_[0];
  for (int c = 0; c < 2; ++c) low_[c] -= kBetweenSections, high_[c] += kBetweenSections;
}

Section Tube::section(double level) const {
  const Cubics all = at(level);
  return {level, all[kWidth].value, all[kDepth].value, all[kMiddle].value, all[kSquare].value};
}

}  // namespace seamwise
