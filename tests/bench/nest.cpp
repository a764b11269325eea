// Layouts of pieces on a board: how long they are, whether that is proven, and what it took.
#include <chrono>

#include "bench.h"
#include "nesting/marker.h"

namespace seamwise::bench {
namespace {

double millisecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

Vec2 pointOf(const Json& json) { return {json.at(0).get<double>(), json.at(1).get<double>()}; }

NestingPiece pieceOf(const Json& json) {
  NestingPiece piece;
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

Json nestTask(const Json& task) {
  auto group = WallpaperGroup::make(task.value("group", "p2"), pointOf(task.at("w1")),
                                    pointOf(task.at("w2")));
  if (!group.ok()) return {{"failure", group.error().message}};
  NestingProblem problem{std::move(group).value()};
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
  const auto start = std::chrono::steady_clock::now();
  auto made = Marker::make(std::move(problem));
  if (!made.ok()) return {{"failure", made.error().message}};
  Marker& marker = *made.value();
  Json shorter = Json::array(), stages = Json::array();
  int count = 0;
  auto stage = marker.stage();
  while (marker.advance(1)) {
    if (marker.count() > count) shorter.push_back({millisecondsSince(start), marker.length()});
    count = marker.count();
    if (marker.stage() != stage) stages.push_back(millisecondsSince(start));
    stage = marker.stage();
  }
  if (marker.error()) return {{"failure", marker.error()->message}};
  Json phases = marker.phaseLengths(), widths = marker.widthLengths();
  return {{"length", marker.length()},
          {"bound", marker.bound()},
          {"proven", marker.isProven()},
          {"free", marker.freeLength()},
          {"phases", phases},
          {"widths", widths},
          {"stages", stages},
          {"milliseconds", millisecondsSince(start)},
          {"shorter", shorter}};
}

}  // namespace seamwise::bench
