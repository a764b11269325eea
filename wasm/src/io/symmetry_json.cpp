#include "io/symmetry_json.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/json_ends.h"
#include "io/json_writer.h"

namespace seamwise {
namespace {

SymmetryRequest readPair(const JsonValue& json, const Place& place) {
  onlyKnown(json, place, {"kind", "pieces", "residual", "map", "mirrors"});
  const JsonValue& pieces = need(json, "pieces", place);
  if (!pieces.isList() || pieces.size() != 2)
    return place.fail(place.shape, "has no two 'pieces'; write [\"one\", \"other\"]");
  PairRequest pair{text(pieces[0], place, "a piece"), text(pieces[1], place, "a piece")};
  if (pair.first == pair.second)
    place.fail(place.shape, "pairs " + inQuotes(pair.first) +
                                " with itself; name two pieces or use the kind 'piece'");
  return pair;
}

SymmetryRequest readSingle(const JsonValue& json, const Place& place) {
  onlyKnown(json, place, {"kind", "piece", "axis", "seams", "residual", "map", "mirrors"});
  const std::string piece = text(need(json, "piece", place), place, "'piece'");
  const JsonValue axis = json.find("axis");
  const JsonValue edges = json.find("seams");
  if (axis && edges) place.fail(place.shape, "has both 'axis' and 'seams'; keep one");
  if (axis) {
    const Polyline ends = polyline(axis, place, "'axis'");
    if (ends.size() != 2 || !((ends[1] - ends[0]).norm() > 1e-3))
      return place.fail(place.shape, "needs an 'axis' of two distinct points; correct it");
    return AxisRequest{piece, ends[0], ends[1]};
  }
  if (edges) {
    if (!edges.isList() || edges.size() != 2)
      place.fail(place.shape, "needs two edge numbers as 'seams'; correct it");
    EdgesRequest request{piece, integer(edges[0], place, "an edge"),
                         integer(edges[1], place, "an edge")};
    if (request.first < 0 || request.second < 0)
      place.fail(place.shape, "has a negative edge number in 'seams'; correct it");
    return request;
  }
  return PieceRequest{piece};
}

/// Rounds to 1e-6 cm, far finer than the tolerance of a mirror; never "-0".
double shortened(double cm) { return std::round(cm * 1e6) / 1e6 + 0.0; }

/// The points where the axis of the panel's own reflection enters and leaves the panel, in input
/// coordinates. [cm]
std::array<Vec2, 2> axisThrough(const Panel& panel, const RigidMotion& map) {
  // R(2 psi + pi) F reflects across the direction psi. The midpoint of p and its image is on the
  // axis.
  const Vec2 along = unit((map.angle - kPi) / 2);
  const Vec2 start = panel.edges.front().start();
  const Vec2 foot = (start + map(start)) / 2;
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Curve& edge : panel.edges)
    for (const Vec2& p : edge.flattened(0.1)) {
      low = std::min(low, along.dot(p - foot));
      high = std::max(high, along.dot(p - foot));
    }
  std::array<Vec2, 2> ends{foot + low * along, foot + high * along};
  if (panel.mirrored_from_input)
    for (Vec2& p : ends) p.x() = -p.x();
  return ends;
}

void writeSymmetry(JsonWriter& out, const Garment& garment, const BodySymmetry& symmetry) {
  const Panel& first = garment.panels[symmetry.pieces[0]];
  out.field("kind", symmetry.single() ? "piece" : "pair");
  if (symmetry.single()) {
    out.field("piece", first.name);
    out.list("axis", axisThrough(first, symmetry.map),
             [&](const Vec2& p) { out.put(Vec2(shortened(p.x()), shortened(p.y()))); });
  } else {
    out.field("pieces", std::vector{first.name, garment.panels[symmetry.pieces[1]].name});
  }
  out.field("residual", shortened(symmetry.residual));
  out.field("map", symmetry.map);
}

}  // namespace

std::vector<SymmetryRequest> readSymmetryList(const JsonValue& json, const Place& outer) {
  std::vector<SymmetryRequest> requests;
  for (const JsonValue& item : array(json, outer, "'symmetries'")) {
    const Place place = numbered(outer, "symmetry", requests.size());
    object(item, place, "symmetry");
    const std::string kind = text(need(item, "kind", place), place, "'kind'");
    if (kind == "pair")
      requests.push_back(readPair(item, place));
    else if (kind == "piece")
      requests.push_back(readSingle(item, place));
    else
      place.fail(place.shape, "is of the unknown kind " + inQuotes(kind) + "; write piece or pair");
  }
  return requests;
}

Outcome<std::vector<SymmetryRequest>> readSymmetries(std::string_view text,
                                                     const std::string& file) {
  const Place place{file, Failure::kSymmetryMalformed, Failure::kSymmetryMalformed};
  return readDocument<std::vector<SymmetryRequest>>(
      text, place, [](const JsonValue& document, const Place& here) {
        object(document, here, "content");
        onlyKnown(document, here, {"$schema", "format", "symmetries"});
        checkFormat(document, here, "seamwise-symmetries", 1);
        return readSymmetryList(need(document, "symmetries", here), here);
      });
}

std::string writeSymmetries(const Garment& garment, const std::vector<BodySymmetry>& symmetries) {
  JsonWriter out;
  out.openObject();
  out.list("symmetries", symmetries, [&](const BodySymmetry& symmetry) {
    out.openObject();
    writeSymmetry(out, garment, symmetry);
    out.close();
  });
  out.close();
  return textOf(out.take());
}

std::string writeMeasured(const Garment& garment, const std::vector<MeasuredSymmetry>& measured) {
  JsonWriter out;
  out.openObject();
  out.list("symmetries", measured, [&](const MeasuredSymmetry& one) {
    out.openObject();
    writeSymmetry(out, garment, one.symmetry);
    out.field("mirrors", one.mirrors);
    out.close();
  });
  out.close();
  return textOf(out.take());
}

}  // namespace seamwise
