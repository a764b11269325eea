#pragma once
#include <algorithm>
#include <limits>
#include <vector>

#include "geometry/vec2.h"

namespace seamwise {

/// Bounding boxes around consecutive items along an outline: one per eight items, and one per
/// sixteen of these boxes. They find the items near a point without a visit to all items.
class BoxedRuns {
 public:
  BoxedRuns() = default;
  /// @param low, high   corners of the items' own boxes [cm]
  BoxedRuns(const Polyline& low, const Polyline& high)
      : runs_(around(low, high, kRun)), groups_(around(lowOf(runs_), highOf(runs_), kGroup)) {}

  /// Visits items in their order, except that the run nearest to p comes first.
  /// @param nearest   square of the distance beyond which items are skipped [cm2]; visit(i) may
  ///                  lower it
  template <class Visit>
  void visitNear(const Vec2& p, const double& nearest, Visit visit) const {
    const std::size_t start = nearestRun(p);
    const auto search = [&](const Box& run) {
      for (std::size_t i = run.first; i < run.last; ++i) visit(i);
    };
    search(runs_[start]);
    for (const Box& group : groups_) {
      if (gap(group, p) > nearest) continue;
      for (std::size_t r = group.first; r < group.last; ++r)
        if (r != start && gap(runs_[r], p) <= nearest) search(runs_[r]);
    }
  }

 private:
  static constexpr std::size_t kRun = 8, kGroup = 16;
  struct Box {
    Vec2 low, high;
    std::size_t first, last;
  };

  static std::vector<Box> around(const Polyline& low, const Polyline& high, std::size_t count) {
    std::vector<Box> boxes;
    for (std::size_t first = 0; first < low.size(); first += count) {
      Box box{low[first], high[first], first, std::min(first + count, low.size())};
      for (std::size_t i = first; i < box.last; ++i) {
        box.low = box.low.cwiseMin(low[i]);
        box.high = box.high.cwiseMax(high[i]);
      }
      boxes.push_back(box);
    }
    return boxes;
  }
  static Polyline lowOf(const std::vector<Box>& boxes) {
    Polyline corners;
    for (const Box& box : boxes) corners.push_back(box.low);
    return corners;
  }
  static Polyline highOf(const std::vector<Box>& boxes) {
    Polyline corners;
    for (const Box& box : boxes) corners.push_back(box.high);
    return corners;
  }
  static double gap(const Box& box, const Vec2& p) {
    return (box.low - p).cwiseMax(p - box.high).cwiseMax(Vec2::Zero()).squaredNorm();
  }

  /// Returns the first of several nearest runs. A search of the nearest group first excludes most
  /// others.
  std::size_t nearestRun(const Vec2& p) const {
    double least = std::numeric_limits<double>::infinity();
    std::size_t nearest = 0, start = 0;
    for (std::size_t g = 0; g < groups_.size(); ++g)
      if (const double away = gap(groups_[g], p); away < least) {
        least = away;
        nearest = g;
      }
    least = std::numeric_limits<double>::infinity();
    const auto search = [&](const Box& group) {
      for (std::size_t r = group.first; r < group.last; ++r) {
        const double away = gap(runs_[r], p);
        if (away > least || (away == least && r > start)) continue;
        least = away;
        start = r;
      }
    };
    search(groups_[nearest]);
    for (std::size_t g = 0; g < groups_.size(); ++g)
      if (g != nearest && gap(groups_[g], p) <= least) search(groups_[g]);
    return start;
  }

  std::vector<Box> runs_, groups_;
};

}  // namespace seamwise
