#include <algorithm>
#include <cmath>

#include "base/sort_by.h"
#include "geometry/curve.h"

namespace seamwise {
namespace {

constexpr double kSliver = 1e-8;       // cm; shorter stretches of a path are skipped
constexpr double kNoSpeed = 1e-7;      // distance of a control point, as a share of the length
constexpr double kCorner = kPi / 12;   // least turn; a blunter one is cut off no more than a bend
constexpr double kCornersApart = 0.1;  // cm; a rounded corner is often drawn as several
constexpr double kPathStep = 0.5;      // cm

}  // namespace

Curve Curve::path(const std::vector<Vec2>& points) {
  Curve c;
  c.kind_ = Kind::kPath;
  c.p_[0] = points.front();
  c.p_[3] = points.back();
  c.marks_.push_back({0, 0});
  const std::size_t count = points.size() / 3;
  const double n = static_cast<double>(count);
  for (std::size_t k = 0; k + 3 < points.size(); k += 3) {
    c.cubics_.push_back(cubic(points[k], points[k + 1], points[k + 2], points[k + 3]));
    c.length_ += c.cubics_.back().length();
    c.marks_.push_back({static_cast<double>(c.cubics_.size()) / n, c.length_});
  }
  return c;
}

double Curve::turningOfPath(double from, double to) const {
  double total = 0;
  const Curve* before = nullptr;
  for (std::size_t k = 0; k < cubics_.size(); ++k) {
    const double start = marks_[k].s, end = marks_[k + 1].s;
    if (std::min(end, to) - std::max(start, from) <= kSliver) continue;
    const Curve& cubic = cubics_[k];
    if (before) total += std::abs(turnBetween(before->endDirection(), cubic.startDirection()));
    total += cubic.turning(std::max(0.0, (from - start) / (end - start)),
                           std::min(1.0, (to - start) / (end - start)));
    before = &cubic;
  }
  return total;
}

Vec2 Curve::startDirection() const {
  for (const int k : {1, 2})
    if ((p_[k] - p_[0]).norm() > kNoSpeed * length_) return p_[k] - p_[0];
  return p_[3] - p_[0];
}

Vec2 Curve::endDirection() const {
  for (const int k : {2, 1})
    if ((p_[3] - p_[k]).norm() > kNoSpeed * length_) return p_[3] - p_[k];
  return p_[3] - p_[0];
}

std::vector<double> Curve::corners() const {
  std::vector<double> shares, keys;
  const Curve* before = nullptr;
  for (std::size_t k = 0; k < cubics_.size(); ++k) {
    const Curve& cubic = cubics_[k];
    if (cubic.length_ <= kSliver) continue;
    const double turn =
        before ? std::abs(turnBetween(before->endDirection(), cubic.startDirection())) : 0;
    before = &cubic;
    if (turn < kCorner) continue;
    const double share = marks_[k].s / length_;
    shares.push_back(share);
    // Equally sharp corners are in order of their distance from the middle, the same from both
    // ends.
    keys.push_back(std::round(1e6 * std::abs(share - 0.5)) / 1e6 - std::round(1e6 * turn));
  }
  const double apart = kCornersApart / length_;
  std::vector<double> taken;
  for (const std::size_t k : placesInOrder(keys)) {
    bool is_free = std::min(shares[k], 1 - shares[k]) > apart;
    for (const double other : taken) is_free &= std::abs(other - shares[k]) > apart;
    if (is_free) taken.push_back(shares[k]);
  }
  sortNumbers(taken);
  return taken;
}

int Curve::stepsAlong(int least) const {
  if (kind_ != Kind::kPath) return least;
  return std::max(least, static_cast<int>(std::ceil(length_ / kPathStep)));
}

}  // namespace seamwise
