#include "io/solved_json.h"

#include <algorithm>
#include <utility>

#include "base/decimal.h"
#include "io/fold_json.h"
#include "io/json_input.h"

namespace seamwise {
namespace {

constexpr std::size_t kMaxPieces = 2000;
constexpr double kMaxAngle = 1e3;  ///< rad

std::vector<Vec2> readPoints(const JsonValue& json, const Place& place, const std::string& what) {
  std::vector<Vec2> points;
  for (const JsonValue& p : array(json, place, what)) {
    points.push_back(point(p, place, "a point of " + what));
    if (place.failed()) break;
  }
  return points;
}

/// Reads whole numbers from 0 to `count` - 1.
std::vector<int> readIndices(const JsonValue& json, const Place& place, const std::string& what,
                             std::size_t count) {
  std::vector<int> indices;
  for (const JsonValue& item : array(json, place, what)) {
    const int index = integer(item, place, "a number of " + what);
    if (index < 0 || static_cast<std::size_t>(index) >= count)
      place.fail(place.number, "has " + decimal(index) + " in " + what + ", but there are " +
                                   decimal(static_cast<std::int64_t>(count)) +
                                   "; align the garment again");
    if (place.failed()) return {};
    indices.push_back(index);
  }
  return indices;
}

template <std::size_t n>
std::array<int, n> readSome(const JsonValue& json, const Place& place, const std::string& what,
                            std::size_t count) {
  const std::vector<int> all = readIndices(json, place, what, count);
  std::array<int, n> some{};
  if (all.size() != n)
    place.fail(place.shape,
               "has " + what + " that are not " + decimal(n) + " numbers; align the garment again");
  else
    std::copy(all.begin(), all.end(), some.begin());
  return some;
}

Vec3 readTriple(const JsonValue& json, const Place& place, const std::string& what, double limit) {
  Vec3 triple = Vec3::Zero();
  if (!json) return triple;
  const std::vector<JsonValue> items = array(json, place, what);
  if (items.size() != 3)
    return place.fail(place.shape,
                      "has " + what + " that is not [x, y, z]; align the garment again"),
           triple;
  for (int c = 0; c < 3; ++c) triple[c] = number(items[c], place, what, limit);
  return triple;
}

/// Reads the piece with index `place.piece`.
void readPiece(const JsonValue& json, const Place& place, SolvedGarment* solved) {
  Piece piece;
  Panel panel;
  piece.name = panel.name = text(need(json, "name", place), place, "'name'");
  piece.rest = readPoints(need(json, "rest", place), place, "'rest'");
  std::vector<Vec2> shape = readPoints(need(json, "shape", place), place, "'shape'");
  const std::size_t count = piece.rest.size();
  piece.outline = readIndices(need(json, "outline", place), place, "'outline'", count);
  for (const JsonValue& hole : array(need(json, "holes", place), place, "'holes'"))
    piece.holes.push_back(readIndices(hole, place, "'holes'", count));
  for (const JsonValue& t : array(need(json, "triangles", place), place, "'triangles'")) {
    piece.triangles.push_back(readSome<3>(t, place, "'triangles'", count));
    if (place.failed()) return;
  }
  if (place.failed()) return;
  int next = 0;
  bool in_order = shape.size() == count && piece.outline.size() >= 3 && !piece.triangles.empty();
  for (const std::vector<int>& loop : loopsOf(piece))
    for (int v : loop) in_order = in_order && v == next++;
  if (!in_order) {
    place.fail(place.shape, "is no piece of a result; align the garment again");
    return;
  }
  double largest = 0;
  for (const auto& triangle : piece.triangles)
    largest = std::max(largest, triangleArea(shape, triangle));
  if (!(largest > 0)) {
    place.fail(place.shape, "has no area as cut; align the garment again");
    return;
  }
  panel.mirrored_from_input = piece.mirrored_from_input = json.find("mirroredFromInput").isTrue();
  if (const JsonValue grain = json.find("grainAngle"))
    panel.grain_angle = number(grain, place, "'grainAngle'", kMaxAngle);
  const JsonValue placement = json.find("placement");
  if (!placement)  // a result written before the drape existed
    place.fail(place.shape, "does not say where it hangs; align the garment again");
  panel.placement_shift =
      readTriple(placement.find("translation"), place, "'translation'", kMaxCoordinateCm);
  panel.placement_turn = readTriple(placement.find("rotation"), place, "'rotation'", kMaxAngle);
  if (const JsonValue folds = json.find("folds")) panel.folds = readPleats(folds, place);
  solved->garment.panels.push_back(std::move(panel));
  solved->pattern.pieces.push_back(std::move(piece));
  solved->shapes.push_back(std::move(shape));
}

SeamSide readSide(const JsonValue& json, const Place& place, const SolvedGarment& solved) {
  const auto& pieces = solved.pattern.pieces;
  SeamSide side;
  const JsonValue member = need(object(json, place, "side"), "piece", place);
  side.piece = integer(member, place, "'piece'");
  if (side.piece < 0 || static_cast<std::size_t>(side.piece) >= pieces.size())
    return place.fail(place.number, "has a side of piece " + decimal(side.piece) +
                                        ", which is none; align the garment again");
  side.vertices = readIndices(need(json, "vertices", place), place, "'vertices'",
                              pieces[static_cast<std::size_t>(side.piece)].outline.size());
  return side;
}

Seam readSeam(const JsonValue& json, const Place& place, const SolvedGarment& solved) {
  Seam seam;
  seam.a = readSide(need(json, "a", place), place, solved);
  seam.b = readSide(need(json, "b", place), place, solved);
  if (place.failed()) return seam;
  if (seam.a.vertices.size() != seam.b.vertices.size() || seam.a.vertices.size() < 2)
    place.fail(place.shape, "has sides of different lengths; align the garment again");
  if (const JsonValue ratio = json.find("lengthRatio"))
    seam.length_ratio = number(ratio, place, "'lengthRatio'", 1e6);
  return seam;
}

Mirror readMirror(const JsonValue& json, const Place& place, const SolvedGarment& solved) {
  const auto& pieces = solved.pattern.pieces;
  Mirror mirror;
  if (const JsonValue pair = json.find("pieces")) {
    const auto both = readSome<2>(pair, place, "'pieces'", pieces.size());
    std::copy(both.begin(), both.end(), mirror.pieces);
  } else {
    const int piece = integer(need(json, "piece", place), place, "'piece'");
    if (piece < 0 || static_cast<std::size_t>(piece) >= pieces.size())
      return place.fail(place.number, "has a piece that is none; align the garment again");
    mirror.pieces[0] = mirror.pieces[1] = piece;
  }
  const JsonValue map = object(need(json, "map", place), place, "'map'");
  mirror.map.angle = number(need(map, "angle", place), place, "'angle'", kMaxAngle);
  mirror.map.shift = point(need(map, "translation", place), place, "'translation'");
  mirror.map.mirrored = true;
  if (place.failed()) return mirror;
  std::size_t outlines = 0;
  const Piece& first = pieces[static_cast<std::size_t>(mirror.pieces[0])];
  const Piece& second = pieces[static_cast<std::size_t>(mirror.pieces[1])];
  for (const std::vector<int>& loop : loopsOf(first)) outlines += loop.size();
  mirror.image.assign(outlines, -1);
  for (const JsonValue& pair : array(need(json, "pairs", place), place, "'pairs'")) {
    const auto [from, to] =
        readSome<2>(pair, place, "'pairs'", std::max(first.rest.size(), second.rest.size()));
    if (static_cast<std::size_t>(from) < outlines &&
        static_cast<std::size_t>(to) < second.rest.size())
      mirror.image[from] = to;
  }
  if (std::count(mirror.image.begin(), mirror.image.end(), -1) > 0)
    place.fail(place.shape, "does not pair all vertices of the outlines; align the garment again");
  return mirror;
}

MatchLine readMatch(const JsonValue& json, const Place& place, const SolvedGarment& solved) {
  MatchLine match;
  const auto side = [&](const char* key, int* piece, Polyline* line) {
    const JsonValue of = object(need(json, key, place), place, "side");
    *piece = integer(need(of, "piece", place), place, "'piece'");
    *line = polyline(need(of, "line", place), place, "'line'");
    if (*piece < 0 || static_cast<std::size_t>(*piece) >= solved.pattern.pieces.size())
      place.fail(place.number, "has a piece that is none; align the garment again");
  };
  side("a", &match.piece_a, &match.a);
  side("b", &match.piece_b, &match.b);
  if (!place.failed() && match.a.size() != match.b.size())
    place.fail(place.shape, "has lines of different numbers of points; align the garment again");
  return match;
}

/// Reads the items of a member of the document up to the first defect.
template <class Read>
void readList(const JsonValue& document, const char* name, const char* what, const Place& place,
              Read read) {
  const JsonValue list = document.find(name);
  if (!list) return;
  std::size_t count = 0;
  for (const JsonValue& item : array(list, place, std::string("'") + name + "'")) {
    if (place.failed()) return;
    const Place here = numbered(place, what, count++);
    read(object(item, here, what), here);
  }
}

std::vector<BodyMeasure> readMeasures(const JsonValue& json, const Place& place) {
  std::vector<BodyMeasure> measures;
  for (const JsonMember& member : object(json, place, "body").members())
    for (const MeasureName& known : kMeasureNames)
      if (known.name == member.name)
        measures.push_back(
            {member.name, number(member.value, place, "'" + member.name + "'", 1e4)});
  return measures;
}

SolvedGarment readSolvedGarment(const JsonValue& document, const Place& place) {
  SolvedGarment solved;
  object(document, place, "result");
  if (place.failed()) return solved;
  checkFormat(document, place, "seamwise-result", 1);
  const std::vector<JsonValue> pieces = array(need(document, "pieces", place), place, "'pieces'");
  if (!place.failed() && (pieces.empty() || pieces.size() > kMaxPieces))
    place.fail(place.shape, "holds no pieces of a result; align a garment first");
  for (const JsonValue& json : pieces) {
    if (place.failed()) return solved;
    Place here = numbered(place, "piece", solved.pattern.pieces.size());
    here.piece = static_cast<int>(solved.pattern.pieces.size());
    readPiece(object(json, here, "piece"), here, &solved);
  }
  readList(document, "seams", "seam", place, [&](const JsonValue& json, const Place& here) {
    solved.pattern.seams.push_back(readSeam(json, here, solved));
  });
  readList(document, "symmetries", "symmetry", place,
           [&](const JsonValue& json, const Place& here) {
             solved.pattern.mirrors.push_back(readMirror(json, here, solved));
           });
  readList(document, "matches", "match", place, [&](const JsonValue& json, const Place& here) {
    solved.garment.matches.push_back(readMatch(json, here, solved));
  });
  solved.garment.size = document.find("size").text();
  if (const JsonValue body = document.find("body")) solved.garment.body = readMeasures(body, place);
  return solved;
}

}  // namespace

Outcome<SolvedGarment> readSolved(std::string_view text, const std::string& file) {
  Place place{file, Failure::kNotAGarment, Failure::kNumber};
  place.keeps_unknown = true;
  return readDocument<SolvedGarment>(text, place, readSolvedGarment);
}

Outcome<std::vector<BodyMeasure>> readBody(std::string_view text, const std::string& file) {
  return readDocument<std::vector<BodyMeasure>>(text, {file, Failure::kNumber, Failure::kNumber},
                                                readMeasures);
}

}  // namespace seamwise
