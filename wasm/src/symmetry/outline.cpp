#include "symmetry/outline.h"

#include <algorithm>
#include <limits>

#include "tuning/symmetry.h"

namespace seamwise {
Outline::Outline(const Panel& panel) {
  for (std::size_t k = 0; k < panel.edges.size(); ++k) append(panel.edges[k], static_cast<int>(k));
  for (const Segment& s : segments_) area_ += 0.5 * cross(s.from, s.from + s.step);
  sampleEvenly();
  for (const std::vector<Curve>& hole : panel.holes)
    for (const Curve& curve : hole) append(curve, -1);
  Polyline low, high;
  for (const Segment& s : segments_) {
    const Vec2 end = s.from + s.step;
    low.push_back(s.from.cwiseMin(end));
    high.push_back(s.from.cwiseMax(end));
  }
  segment_boxes_ = BoxedRuns(low, high);
  corner_boxes_ = BoxedRuns(corners_, corners_);
}

void Outline::append(const Curve& curve, int edge) {
  const Polyline line = curve.flattened(kFlatness);
  const int first = static_cast<int>(segments_.size());
  double length = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec2 step = line[i + 1] - line[i];
    const double l = step.norm();
    if (!(l > 0)) continue;
    segments_.push_back({line[i], step, 1 / (l * l), edge, length, l});
    length += l;
    const int pieces = std::max(1, static_cast<int>(std::ceil(l / SymmetryTuning::kSampleSpacing)));
    for (int k = 0; k < pieces; ++k) samples_.push_back(line[i] + step * (double(k) / pieces));
  }
  for (std::size_t i = first; i < segments_.size(); ++i) {
    segments_[i].start /= length;
    segments_[i].span /= length;
  }
  corners_.push_back(curve.start());
  for (const double s : curve.corners()) corners_.push_back(curve.atFraction(s));
  if (edge < 0) return;
  edges_.push_back({first, static_cast<int>(segments_.size()), length});
  length_ += length;
}

void Outline::sampleEvenly() {
  std::size_t i = 0;
  double passed = 0;
  for (int k = 0; k < kEven; ++k) {
    const double wanted = length_ * k / kEven;
    double l = 1 / std::sqrt(segments_[i].inverse_square);
    while (passed + l < wanted && i + 1 < segments_.size()) {
      passed += l;
      l = 1 / std::sqrt(segments_[++i].inverse_square);
    }
    even_[k] = segments_[i].from + segments_[i].step * std::min(1.0, (wanted - passed) / l);
  }
}

Vec2 Outline::at(int edge, double fraction) const {
  const Edge& e = edges_[edge];
  const auto begin = segments_.begin() + e.first, end = segments_.begin() + e.last;
  auto s = std::upper_bound(begin, end, fraction,
                            [](double f, const Segment& segment) { return f < segment.start; });
  if (s != begin) --s;
  return s->from + s->step * std::clamp((fraction - s->start) / s->span, 0.0, 1.0);
}

OutlinePoint Outline::nearest(const Vec2& p) const {
  double best = std::numeric_limits<double>::infinity(), along = 0;
  const Segment* found = nullptr;
  segment_boxes_.visitNear(p, best, [&](std::size_t i) {
    const Segment& s = segments_[i];
    const Vec2 v = p - s.from;
    const double t = std::clamp(v.dot(s.step) * s.inverse_square, 0.0, 1.0);
    const double d = (v - t * s.step).squaredNorm();
    if (d >= best) return;
    best = d;
    along = t;
    found = &s;
  });
  return {found->from + along * found->step, std::sqrt(best), found->edge,
          found->start + along * found->span};
}

int Outline::nearestCorner(const Vec2& p) const {
  double best = std::numeric_limits<double>::infinity();
  std::size_t found = 0;
  corner_boxes_.visitNear(p, best, [&](std::size_t i) {
    const double d = (corners_[i] - p).squaredNorm();
    if (d > best || (d == best && i > found)) return;
    best = d;
    found = i;
  });
  return static_cast<int>(found);
}

}  // namespace seamwise
