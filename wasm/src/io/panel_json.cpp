#include "io/panel_json.h"

#include <algorithm>
#include <array>

#include "base/decimal.h"
#include "io/outline_check.h"
#include "io/panel_extras_json.h"

namespace seamwise {
namespace {

constexpr double kShortestEdgeCm = 1e-3;
constexpr double kLargestRadiusCm = 1e7;
constexpr std::size_t kMaxEdges = 10'000;
constexpr std::size_t kMaxCubics = 2'000, kMaxCubicsOfPanel = 10'000;

const RigidMotion kTurnOver{0.0, Vec2::Zero(), true};  // (x, y) -> (-x, y)

std::array<int, 2> readEndpoints(const JsonValue& edge, const Place& place, std::size_t vertices) {
  const JsonValue ends = edge.find("endpoints");
  if (!ends.isList() || ends.size() != 2)
    return place.fail(Failure::kEdgeIndex, "has no pair of 'endpoints'; write two vertex numbers");
  std::array<int, 2> numbers{};
  for (std::size_t i = 0; i < 2; ++i) {
    numbers[i] = integer(ends[i], place, "an endpoint");
    if (numbers[i] < 0 || static_cast<std::size_t>(numbers[i]) >= vertices)
      place.fail(Failure::kEdgeIndex, "ends at vertex " + decimal(numbers[i]) + ", the panel has " +
                                          decimal(vertices) + " (0 to " +
                                          decimal(static_cast<long>(vertices) - 1) +
                                          "); correct its endpoints");
  }
  return numbers;
}

Vec2 readControl(const JsonValue& json, const Place& place, const PanelUnits& units, const Vec2& a,
                 const Vec2& b) {
  Place here = place;
  here.number = Failure::kCurvature;
  if (units.absolute_controls) return point(json, here, "a control point", units.cm);
  const Vec2 c = point(json, here, "a control point", 1, 1e300);
  const Vec2 p = a + c.x() * (b - a) + c.y() * perp(b - a);
  if (p.cwiseAbs().maxCoeff() <= kMaxCoordinateCm) return p;
  here.fail(Failure::kCurvature, "has a control point more than 100 m away; correct it");
  return a;
}

/// Reads an arc. Its radius is in units of the file, not of the chord; flags are true/false or 0/1.
Curve readArc(const JsonValue& params, const Place& place, const PanelUnits& units, const Vec2& a,
              const Vec2& b) {
  Place here = place;
  here.number = Failure::kCurvature;
  const double radius = units.cm * number(params[0], here, "radius", 1e300);
  if (!(radius > 0) || radius > kLargestRadiusCm)
    return here.fail(Failure::kCurvature, "is an arc of radius " + shown(radius) +
                                              " cm; write a positive radius of usual size");
  const auto flag = [&](const JsonValue& json, const char* what) {
    return json.isBoolean() ? json.isTrue() : number(json, here, what, 1e300) != 0;
  };
  return Curve::arc(a, b, radius, flag(params[1], "'large arc'"), flag(params[2], "'right'"));
}

/// Reads a path: cubics of two control points and an end point, which the last cubic omits.
template <class Control>
Curve readPath(const JsonValue& params, const Place& place, const Vec2& a, const Vec2& b,
               const Control& control) {
  const std::vector<JsonValue> cubics = params.items();
  if (cubics.size() > kMaxCubics)
    return place.fail(Failure::kTooLarge, "has a path of " + decimal(cubics.size()) +
                                              " cubics; draw it with at most " +
                                              decimal(kMaxCubics));
  std::vector<Vec2> points{a};
  bool is_path = !cubics.empty();
  for (const JsonValue& cubic : cubics) {
    const bool is_last = points.size() == 3 * cubics.size() - 2;
    is_path &= cubic.size() == (is_last ? 2 : 3);
    for (const JsonValue& point : cubic.items()) points.push_back(control(point));
  }
  points.push_back(b);
  if (!is_path)
    return place.fail(Failure::kCurvature,
                      "has a malformed path; write its cubics as [[c1, c2, point], ..., [c1, c2]]");
  return points.size() == 4 ? Curve::cubic(a, points[1], points[2], b) : Curve::path(points);
}

Curve readCurve(const JsonValue& edge, const Place& place, const PanelUnits& units, const Vec2& a,
                const Vec2& b) {
  const JsonValue curvature = edge.find("curvature");
  if (!curvature) return Curve::line(a, b);
  const auto control = [&](const JsonValue& json) { return readControl(json, place, units, a, b); };
  if (curvature.isList()) return Curve::quadratic(a, control(curvature), b);

  const JsonValue type = curvature.find("type");
  const JsonValue params = curvature.find("params");
  if (!type.isText() || !params.isList())
    return place.fail(Failure::kCurvature,
                      "has a malformed 'curvature'; write {\"type\": ..., \"params\": [...]}");
  const auto expect = [&](std::size_t count, const char* what) {
    if (params.size() != count)
      place.fail(Failure::kCurvature, "has " + decimal(params.size()) + " params in its " + what +
                                          ", which needs " + decimal(count) + "; correct them");
  };
  const std::string name = type.text();
  if (name == "quadratic") {
    expect(1, "quadratic curve");
    return Curve::quadratic(a, control(params[0]), b);
  }
  if (name == "cubic") {
    expect(2, "cubic curve");
    return Curve::cubic(a, control(params[0]), control(params[1]), b);
  }
  if (name == "circle") {
    expect(3, "circle arc");
    return readArc(params, place, units, a, b);
  }
  if (name == "path") return readPath(params, place, a, b, control);
  return place.fail(Failure::kCurvature, "has a curvature of unknown type " + inQuotes(name) +
                                             "; known are quadratic, cubic, circle, path");
}

Vec3 readTriple(const JsonValue& panel, const char* key, const Place& place, double scale) {
  const JsonValue json = panel.find(key);
  if (!json) return Vec3::Zero();
  const std::string what = "'" + std::string(key) + "'";
  if (!json.isList() || json.size() != 3)
    place.fail(place.number, "has a malformed " + what + "; write three numbers");
  Vec3 triple;
  for (int i = 0; i < 3; ++i)
    triple[i] = scale * number(json[static_cast<std::size_t>(i)], place, what, 1e7);
  return triple;
}

}  // namespace

std::vector<Curve> readLoop(const JsonValue& json, const std::vector<Vec2>& vertices,
                            const PanelUnits& units, const Place& place, std::size_t* cubics) {
  const std::vector<JsonValue> edges = array(json, place, "'edges'");
  if (edges.size() < 2)
    return place.fail(Failure::kOutlineOpen,
                      "has " + decimal(edges.size()) + " edges; an outline needs at least two");
  if (edges.size() > kMaxEdges)
    return place.fail(Failure::kTooLarge, "has more than " + decimal(kMaxEdges) +
                                              " edges; draw it with fewer, curved ones");
  std::vector<std::array<int, 2>> ends;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const Place here = numbered(place, "edge", k);
    ends.push_back(readEndpoints(object(edges[k], here, "edge"), here, vertices.size()));
  }
  if (place.failed()) return {};
  const auto vertex = [&](int i) { return vertices[static_cast<std::size_t>(i)]; };
  std::vector<Curve> loop;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const std::size_t next = (k + 1) % edges.size();
    const Vec2 a = vertex(ends[k][0]), b = vertex(ends[next][0]);
    const double gap = (vertex(ends[k][1]) - b).norm();
    if (gap >= kShortestEdgeCm)  // a corner may be stored as two vertices at the same point
      return place.fail(Failure::kOutlineOpen, "has an open outline: edge " + decimal(next) +
                                                   " starts " + shown(gap) +
                                                   " cm from where edge " + decimal(k) +
                                                   " ends; list the edges head to tail");
    const Place here = numbered(place, "edge", k);
    const bool arc_on_a_point = (b - a).norm() < kShortestEdgeCm && !units.absolute_controls;
    const Curve curve = arc_on_a_point ? Curve::line(a, b) : readCurve(edges[k], here, units, a, b);
    if (curve.length() < kShortestEdgeCm)
      here.fail(Failure::kEdgeZeroLength,
                "is shorter than 0.001 cm; remove it or move its ends apart");
    checkEdgeExtras(edges[k], units, here);
    *cubics += curve.cubics();
    if (*cubics > kMaxCubicsOfPanel)
      place.fail(Failure::kTooLarge, "has paths of more than " + decimal(kMaxCubicsOfPanel) +
                                         " cubics in all; draw them with fewer");
    if (place.failed()) return {};
    loop.push_back(curve);
  }
  return loop;
}

Panel readPanel(const std::string& name, const JsonValue& json, const PanelUnits& units,
                const Place& place) {
  object(json, place, "panel");
  std::vector<Vec2> vertices;
  const std::vector<JsonValue> points = array(need(json, "vertices", place), place, "'vertices'");
  for (std::size_t i = 0; i < points.size(); ++i)
    vertices.push_back(point(points[i], place, "vertex " + decimal(i), units.cm));

  Panel panel;
  panel.name = name;
  std::size_t cubics = 0;
  panel.edges = readLoop(need(json, "edges", place), vertices, units, place, &cubics);
  if (place.failed()) return panel;
  checkOutline(panel.edges, place);
  if (place.failed()) return panel;
  panel.mirrored_from_input = signedArea(panel.edges) < 0;
  if (panel.mirrored_from_input)
    for (Curve& edge : panel.edges) edge = edge.transformed(kTurnOver);
  panel.placement_shift = readTriple(json, "translation", place, units.cm);
  panel.placement_turn = readTriple(json, "rotation", place, kPi / 180);
  readExtras(json, vertices, units, place, &panel, cubics);
  return panel;
}

}  // namespace seamwise
