#include "bindings/marker_handle.h"

#include <array>
#include <utility>
#include <vector>

namespace seamwise {
namespace {

constexpr std::array<const char*, 6> kMarkerStages = {"tables", "lay",    "prove",
                                                      "free",   "widths", "done"};

std::vector<double> numbers(const val& list) {
  return emscripten::convertJSArrayToNumberVector<double>(list);
}

Polyline points(const val& list) {
  const std::vector<double> flat = numbers(list);
  Polyline line;
  for (std::size_t k = 0; k + 1 < flat.size(); k += 2) {
    const Vec2 point(flat[k], flat[k + 1]);
    line.push_back(point);
  }
  return line;
}

MarkerPiece pieceOf(const val& given) {
  const auto number = [&](const char* field) { return given[field].as<double>(); };
  MarkerPiece piece;
  piece.name = given["name"].as<std::string>();
  piece.garment = given["garment"].as<int>();
  piece.outline = points(given["outline"]);
  piece.alignment = {number("angle"), {number("x"), number("y")}, false};
  const auto turns = given["turns"].as<std::string>();
  piece.turns = turns == "any"       ? LayTurns::kAny
                : turns == "quarter" ? LayTurns::kQuarter
                                     : LayTurns::kHalf;
  piece.up = {number("upX"), number("upY")};
  piece.shifts = points(given["shifts"]);
  const std::vector<double> pin = numbers(given["pin"]);
  if (pin.size() == 3) piece.pin = RigidMotion{pin[0], {pin[1], pin[2]}, false};
  return piece;
}

Outcome<MarkerProblem> problemOf(const val& request) {
  const auto number = [&](const char* field) { return request[field].as<double>(); };
  auto group = WallpaperGroup::make(request["group"].as<std::string>(),
                                    {number("w1x"), number("w1y")}, {number("w2x"), number("w2y")});
  if (!group.ok()) return group.error();
  MarkerProblem problem{std::move(group).value()};
  const val pieces = request["pieces"], flaws = request["flaws"];
  problem.pieces = std::vector<MarkerPiece>(pieces["length"].as<std::size_t>());
  for (std::size_t k = 0; k < problem.pieces.size(); ++k) problem.pieces[k] = pieceOf(pieces[k]);
  problem.flaws = std::vector<Polyline>(flaws["length"].as<std::size_t>());
  for (std::size_t k = 0; k < problem.flaws.size(); ++k) problem.flaws[k] = points(flaws[k]);
  problem.width = number("width");
  problem.selvedge = number("selvedge");
  problem.gap = number("gap");
  problem.repeat_tolerance = number("repeatTolerance");
  const auto nap = request["nap"].as<std::string>();
  problem.nap = nap == "one-way" ? Nap::kOneWay : nap == "garment" ? Nap::kGarment : Nap::kNone;
  problem.whole_repeats = request["wholeRepeats"].as<bool>();
  problem.ignores_print = request["ignoresPrint"].as<bool>();
  problem.phases = numbers(request["phases"]);
  const double start = number("start");
  if (start == start) problem.start = start;
  problem.widths = numbers(request["widths"]);
  problem.also_free = request["alsoFree"].as<bool>();
  problem.effort = number("effort");
  problem.seed = static_cast<std::uint64_t>(number("seed"));
  return problem;
}

val placesValue(const std::vector<RigidMotion>& places) {
  std::vector<double> flat;
  for (const RigidMotion& place : places)
    for (const double number : {place.angle, place.shift.x(), place.shift.y()})
      flat.push_back(number);
  return copied(flat);
}

}  // namespace

MarkerHandle::MarkerHandle(const val& request) {
  auto problem = problemOf(request);
  if (!problem.ok()) {
    error_ = problem.error();
    return;
  }
  auto marker = Marker::make(std::move(problem).value());
  if (marker.ok())
    marker_ = std::move(marker).value();
  else
    error_ = marker.error();
}

bool MarkerHandle::advance(double work) {
  if (error_) return false;
  const bool more = marker_->advance(work);
  error_ = marker_->error();
  return more && !error_;
}

std::string MarkerHandle::stage() const {
  return kMarkerStages[marker_ ? static_cast<std::size_t>(marker_->stage()) : 0];
}

val MarkerHandle::layout() const {
  val value = val::object();
  value.set("length", marker_->length());
  value.set("originX", marker_->origin().x());
  value.set("originY", marker_->origin().y());
  value.set("places", placesValue(marker_->places()));
  return value;
}

val MarkerHandle::report() const {
  val value = val::object();
  value.set("bound", marker_->bound());
  value.set("proven", marker_->isProven());
  value.set("freeLength", marker_->freeLength());
  value.set("phaseLengths", copied(marker_->phaseLengths()));
  value.set("widthLengths", copied(marker_->widthLengths()));
  return value;
}

}  // namespace seamwise
