#include "io/match_json.h"

#include <algorithm>
#include <cmath>

#include "geometry/polygon.h"
#include "io/outline_check.h"

namespace seamwise {
namespace {

constexpr double kSpacingCm = 1.0;
constexpr double kShortestLineCm = 0.1;
constexpr double kOutsideCm = 1.0;  ///< tolerance for lines drawn slightly outside their piece

struct Side {
  int piece;
  Polyline line;
  double length;
};

double lengthOf(const Polyline& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
  return length;
}

/// Greatest distance of a line's points outside its piece. [cm]
double outside(const Polyline& line, const Panel& panel) {
  const Polyline closed = asPolygon(panel.edges);
  Polyline outline = closed;
  outline.push_back(closed.front());
  double farthest = 0;
  for (const Vec2& p : line)
    if (!contains(closed, p)) farthest = std::max(farthest, nearestOnPolyline(outline, p).distance);
  return farthest;
}

Side readSide(const JsonValue& match, const char* key, const Place& outer, const Garment& garment) {
  const Place place = outer.in(std::string("side ") + key);
  const JsonValue json = object(need(match, key, outer), place, "side");
  onlyKnown(json, place, {"piece", "line"});
  const std::string name = text(need(json, "piece", place), place, "'piece'");
  Side side;
  side.piece = garment.find(name);
  if (side.piece < 0)
    return place.fail(place.shape, "names piece " + inQuotes(name) +
                                       ", which the garment has not; correct the name");
  side.line = polyline(need(json, "line", place), place, "'line'");
  const Panel& panel = garment.panels[static_cast<std::size_t>(side.piece)];
  if (panel.mirrored_from_input)
    for (Vec2& p : side.line) p.x() = -p.x();
  if (const double off = outside(side.line, panel); off > kOutsideCm)
    place.fail(place.shape, "has a line that lies " + shown(off) + " cm outside piece " +
                                inQuotes(name) + "; draw it on the piece, in its coordinates");
  side.length = lengthOf(side.line);
  if (!(side.length >= kShortestLineCm))
    place.fail(place.shape,
               "has a line shorter than " + shown(kShortestLineCm) + " cm; draw it longer");
  return side;
}

/// `count` points of `line`, evenly spaced by arc length; the first and the last are its ends.
Polyline resampled(const Polyline& line, double length, std::size_t count) {
  Polyline points{line.front()};
  std::size_t i = 1;
  double before = 0;  // arc length at line[i - 1]
  for (std::size_t k = 1; k + 1 < count; ++k) {
    const double target = length * static_cast<double>(k) / static_cast<double>(count - 1);
    double step = (line[i] - line[i - 1]).norm();
    while (i + 1 < line.size() && before + step < target) {
      before += step;
      ++i;
      step = (line[i] - line[i - 1]).norm();
    }
    const double t = step > 0 ? std::min(1.0, (target - before) / step) : 0;
    points.push_back(line[i - 1] + t * (line[i] - line[i - 1]));
  }
  points.push_back(line.back());
  return points;
}

}  // namespace

std::vector<MatchLine> readMatches(const JsonValue& json, const Place& outer,
                                   const Garment& garment) {
  std::vector<MatchLine> matches;
  for (const JsonValue& item : array(json, outer, "'matches'")) {
    const Place place = numbered(outer, "match", matches.size());
    object(item, place, "match");
    onlyKnown(item, place, {"a", "b", "weight", "name"});
    const Side a = readSide(item, "a", place, garment), b = readSide(item, "b", place, garment);
    if (place.failed()) return {};
    MatchLine match;
    match.piece_a = a.piece;
    match.piece_b = b.piece;
    const double longest = std::max(a.length, b.length);
    const auto count = 1 + static_cast<std::size_t>(std::ceil(longest / kSpacingCm - 1e-9));
    match.a = resampled(a.line, a.length, count);
    match.b = resampled(b.line, b.length, count);
    if (const JsonValue weight = item.find("weight")) {
      match.weight = number(weight, place, "'weight'", 1e6);
      if (match.weight < 0) place.fail(place.number, "has a negative weight; write 0 or more");
    }
    matches.push_back(std::move(match));
  }
  return matches;
}

}  // namespace seamwise
