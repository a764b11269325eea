#include "symmetry/outline.h"

#include <algorithm>
#include <limits>

namespace seamwise {
namespace {

constexpr double kSampleSpacing = 2.0;  // cm; straight runs need no more, curves are finer anyway
constexpr int kBoxSegments = 8;

}  // namespace

Outline::Outline(const Panel& panel) {
  for (std::size_t k = 0; k < panel.edges.size(); ++k) append(panel.edges[k], static_cast<int>(k));
  for (const Segment& s : segments_) area_ += 0.5 * cross(s.from, s.from + s.step);
  sampleEvenly();
  for (const std::vector<Curve>& hole : panel.holes)
    for (const Curve& curve : hole) append(curve, -1);
  for (std::size_t first = 0; first < segments_.size(); first += kBoxSegments) {
    const std::size_t last = std::min(first + kBoxSegments, segments_.size());
    Box box{segments_[first].from, segments_[first].from, static_cast<int>(first),
            static_cast<int>(last)};
    for (std::size_t i = first; i < last; ++i) {
      const Vec2 end = segments_[i].from + segments_[i].step;
      box.low = box.low.cwiseMin(segments_[i].from).cwiseMin(end);
      box.high = box.high.cwiseMax(segments_[i].from).cwiseMax(end);
    }
    boxes_.push_back(box);
  }
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
    const int pieces = std::max(1, static_cast<int>(std::ceil(l / kSampleSpacing)));
    for (int k = 0; k < pieces; ++k) samples_.push_back(line[i] + step * (double(k) / pieces));
  }
  for (std::size_t i = first; i < segments_.size(); ++i) {
    segments_[i].start /= length;
    segments_[i].span /= length;
  }
  corners_.push_back(curve.start());
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
  const auto gap = [&](const Box& box) {
    return (box.low - p).cwiseMax(p - box.high).cwiseMax(Vec2::Zero()).squaredNorm();
  };
  std::size_t start = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < boxes_.size() && least > 0; ++i)
    if (const double g = gap(boxes_[i]); g < least) {
      least = g;
      start = i;
    }

  double best = std::numeric_limits<double>::infinity(), along = 0;
  const Segment* found = nullptr;
  const auto search = [&](const Box& box) {
    for (int i = box.first; i < box.last; ++i) {
      const Segment& s = segments_[i];
      const Vec2 v = p - s.from;
      const double t = std::clamp(v.dot(s.step) * s.inverse_square, 0.0, 1.0);
      const double d = (v - t * s.step).squaredNorm();
      if (d >= best) continue;
      best = d;
      along = t;
      found = &s;
    }
  };
  search(boxes_[start]);
  for (std::size_t i = 0; i < boxes_.size(); ++i)
    if (i != start && gap(boxes_[i]) < best) search(boxes_[i]);
  return {found->from + along * found->step, std::sqrt(best), found->edge,
          found->start + along * found->span};
}

}  // namespace seamwise
