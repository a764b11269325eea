// Layouts of pieces on a board: length, proof, and time in factorisations of a grid in the same
// process.
#include "bench.h"
#include "marker/marker.h"

namespace seamwise::bench {
namespace {

Vec2 pointOf(const Json& json) { return {json.at(0).get<double>(), json.at(1).get<double>()}; }

MarkerPiece pieceOf(const Json& json) {
  MarkerPiece piece;
  piece.name = json.value("name", "piece");
  piece.garment = json.value("garment", 0);
  for (const Json& point : json.at("outline")) piece.outline.push_back(pointOf(point));
  piece.alignment = {json.value("angle", 0.0), {json.value("x", 0.0), json.value("y", 0.0)}, false};
  const std::string turns = json.value("turns", "half");
  piece.turns = turns == "any"       ? LayTurns::kAny
                : turns == "quarter" ? LayTurns::kQuarter
                                     : LayTurns::kHalf;
  return piece;
}

}  // namespace

Json markerTask(const Json& task) {
  auto group = WallpaperGroup::make(task.value("group", "p2"), pointOf(task.at("w1")),
                                    pointOf(task.at("w2")));
  if (!group.ok()) return {{"failure", group.error().message}};
  MarkerProblem problem{std::move(group).value()};
  for (const Json& piece : task.at("pieces")) problem.pieces.push_back(pieceOf(piece));
  problem.width = task.at("width");
  problem.selvedge = task.value("selvedge", 0.0);
  problem.gap = task.value("gap", 0.0);
  problem.ignores_print = task.value("free", false);
  problem.also_free = task.value("alsoFree", false);
  problem.phases = task.value("phases", std::vector<double>{0});
  problem.widths = task.value("widths", std::vector<double>{});
  problem.effort = task.value("effort", 1.0);
  problem.seed = task.value("seed", 1);
  const double unit = gridFactorisation();
  const Watch watch;
  auto made = Marker::make(std::move(problem));
  if (!made.ok()) return {{"failure", made.error().message}};
  Marker& marker = *made.value();
  Json shorter = Json::array(), stages = Json::array();
  double first = 0;
  for (bool goes_on = true; goes_on;) {
    const int count = marker.count();
    const Marker::Stage stage = marker.stage();
    goes_on = marker.advance(1);
    const double now = watch.milliseconds();
    if (count == 0 && marker.count() > 0) first = now;
    if (marker.count() > count) shorter.push_back({now, marker.length()});
    if (marker.stage() != stage) stages.push_back(now);
  }
  const double whole = watch.milliseconds();
  if (marker.error()) return {{"failure", marker.error()->message}};
  return {{"length", marker.length()},
          {"bound", marker.bound()},
          {"proven", marker.isProven()},
          {"free", marker.freeLength()},
          {"phases", marker.phaseLengths()},
          {"widths", marker.widthLengths()},
          {"unit", unit},
          {"first", first / unit},
          {"whole", whole / unit},
          {"milliseconds", {{"first", first}, {"whole", whole}}},
          {"stages", stages},
          {"shorter", shorter}};
}

}  // namespace seamwise::bench
