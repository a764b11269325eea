#include "io/outline_check.h"

#include <algorithm>
#include <cmath>

#include "base/decimal.h"
#include "geometry/polygon.h"

namespace seamwise {
namespace {

constexpr double kFlatCm = 1e-3;
constexpr double kSmallestAreaCm2 = 1e-3;
constexpr std::size_t kMaxPoints = 400'000;

/// A loop of curves as a polygon with references to its edges.
struct Flat {
  Polyline points;
  std::vector<std::size_t> edge;  ///< index of the curve that contains the side after each point
};

Flat flattened(const std::vector<Curve>& loop, const Place& place) {
  Flat flat;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Polyline line = loop[k].flattened(kFlatCm);
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      if (line[i] == line[i + 1]) continue;
      flat.points.push_back(line[i]);
      flat.edge.push_back(k);
    }
    if (flat.points.size() > kMaxPoints)
      return place.fail(Failure::kTooLarge,
                        "has an outline of more than 400000 points; simplify it");
  }
  return flat;
}

bool onOneLine(const Polyline& points) {
  Vec2 far = Vec2::Zero();
  for (const Vec2& p : points)
    if ((p - points.front()).norm() > far.norm()) far = p - points.front();
  return std::all_of(points.begin(), points.end(), [&](const Vec2& p) {
    return std::abs(cross(far, p - points.front())) <= kFlatCm * far.norm();
  });
}

}  // namespace

Polyline asPolygon(const std::vector<Curve>& loop) {
  Polyline closed;
  for (const Curve& edge : loop) {
    const Polyline line = edge.flattened(kFlatCm);
    closed.insert(closed.end(), line.begin(), line.end() - 1);
  }
  return closed;
}

double signedArea(const std::vector<Curve>& loop) { return signedArea(asPolygon(loop)); }

void checkOutline(const std::vector<Curve>& loop, const Place& place) {
  const Flat flat = flattened(loop, place);
  if (place.failed()) return;
  const char* kNoArea = "encloses no area; correct its vertices or edges";
  if (onOneLine(flat.points)) {
    place.fail(Failure::kOutlineSelfIntersects, kNoArea);
    return;
  }
  if (const auto crossing = findCrossing(flat.points)) {
    const std::size_t s = flat.edge[static_cast<std::size_t>(crossing->first_edge)];
    const std::size_t t = flat.edge[static_cast<std::size_t>(crossing->second_edge)];
    place.fail(Failure::kOutlineSelfIntersects,
               "has an outline that crosses or touches itself near " + shown(crossing->at) +
                   " (edge " + decimal(std::min(s, t)) + " and edge " + decimal(std::max(s, t)) +
                   "); move a vertex or a curve there");
  }
  if (std::abs(signedArea(flat.points)) < kSmallestAreaCm2)
    place.fail(Failure::kOutlineSelfIntersects, kNoArea);
}

void checkHole(const Panel& panel, std::size_t h, const Place& place) {
  std::vector<Polyline> loops{flattened(panel.edges, place).points};
  for (std::size_t i = 0; i <= h; ++i) loops.push_back(flattened(panel.holes[i], place).points);
  if (place.failed()) return;
  if (const auto crossing = findCrossing(loops))
    place.fail(Failure::kOutlineSelfIntersects, "crosses or touches another line near " +
                                                    shown(crossing->at) +
                                                    " (face side up); move the hole");
  const Polyline& hole = loops.back();
  if (!contains(loops.front(), hole.front()))
    place.fail(Failure::kOutlineSelfIntersects, "lies outside the outline; move it inside");
  for (std::size_t other = 0; other < h; ++other)
    if (contains(loops[1 + other], hole.front()) || contains(hole, loops[1 + other].front()))
      place.fail(Failure::kOutlineSelfIntersects,
                 "lies in or around hole " + decimal(other) + "; remove one of them");
}

}  // namespace seamwise
