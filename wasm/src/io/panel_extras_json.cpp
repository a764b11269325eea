#include "io/panel_extras_json.h"

#include <algorithm>
#include <utility>

#include "base/decimal.h"
#include "io/fold_json.h"
#include "io/outline_check.h"

namespace seamwise {
namespace {

constexpr double kWidestAllowanceCm = 20;

/// Returns the direction of a grain line in the frame of the face-up piece. [rad]
double grainAngle(const JsonValue& line, const PanelUnits& units, const Place& place,
                  const Panel& panel) {
  const Polyline ends = polyline(line, place, "'line'", units.cm);
  if (ends.size() != 2 || !((ends[1] - ends[0]).norm() > 1e-3)) {
    place.fail(place.shape, "needs a 'line' of two distinct points; correct it");
    return kPi / 2;
  }
  Vec2 d = ends[1] - ends[0];
  if (panel.mirrored_from_input) d.x() = -d.x();
  return std::atan2(d.y(), d.x());
}

void readGrain(const JsonValue& json, const PanelUnits& units, const Place& outer, Panel* panel) {
  const Place place = outer.in("grain");
  object(json, place, "grain");
  if (const JsonValue line = json.find("line")) {
    panel->grain_angle = grainAngle(line, units, place, *panel);
    panel->grain_stated = true;
  }
  if (const JsonValue lock = json.find("lock")) panel->grain_lock = readGrainLock(lock, place);
  if (const JsonValue degrees = json.find("toleranceDeg"))
    panel->grain_tolerance = readGrainTolerance(degrees, place);
}

/// The first of several grain lines applies, unless the panel states the one to use.
void readGrains(const JsonValue& json, const PanelUnits& units, const Place& place, Panel* panel) {
  std::size_t n = 0;
  for (const JsonValue& item : array(json, place, "'grains'")) {
    const Place here = numbered(place, "grain line", n++);
    object(item, here, "grain line");
    if (const JsonValue name = item.find("name")) text(name, here, "'name'");
    const JsonValue line = item.find("line");
    const double angle =
        line ? grainAngle(line, units, here, *panel)
             : number(need(item, "angleDeg", here), here, "'angleDeg'", 360) * kPi / 180;
    if (here.failed()) return;
    if (!std::exchange(panel->grain_stated, true)) panel->grain_angle = angle;
  }
}

void readHoles(const JsonValue& json, const std::vector<Vec2>& vertices, const PanelUnits& units,
               const Place& place, Panel* panel, std::size_t cubics) {
  for (const JsonValue& item : array(json, place, "'holes'")) {
    const std::size_t h = panel->holes.size();
    const Place here = numbered(place, "hole", h);
    std::vector<Curve> loop = readLoop(item, vertices, units, here, &cubics);
    if (here.failed()) return;
    checkOutline(loop, here);
    if (here.failed()) return;
    if (panel->mirrored_from_input)
      for (Curve& edge : loop) edge = edge.transformed({0.0, Vec2::Zero(), true});
    const bool reversed = signedArea(loop) > 0;
    if (reversed) {
      std::reverse(loop.begin(), loop.end());
      for (Curve& edge : loop) edge = edge.reversed();
    }
    panel->holes.push_back(std::move(loop));
    panel->hole_reversed.push_back(reversed);
    checkHole(*panel, h, here);
  }
}

void checkNotches(const JsonValue& json, const Place& place, std::size_t edges) {
  std::size_t n = 0;
  for (const JsonValue& notch : array(json, place, "'notches'")) {
    const Place here = numbered(place, "notch", n++);
    const int edge = integer(need(object(notch, here, "notch"), "edge", here), here, "'edge'");
    if (edge < 0 || static_cast<std::size_t>(edge) >= edges)
      here.fail(Failure::kEdgeIndex, "is on edge " + decimal(edge) + ", the panel has " +
                                         decimal(edges) + "; correct its 'edge'");
    const double at = number(need(notch, "at", here), here, "'at'", 1);
    if (at < 0) here.fail(here.number, "has a negative 'at'; write a fraction between 0 and 1");
  }
}

void checkAllowance(const JsonValue& json, const PanelUnits& units, const Place& place) {
  const JsonValue width = json.isObject() ? need(json, "width", place) : json;
  const double cm = units.cm * number(width, place, "the width of 'allowance'", 1e300);
  if (!(cm >= 0 && cm <= kWidestAllowanceCm))
    place.fail(place.number,
               "has an 'allowance' of " + shown(cm) + " cm; write a width from 0 to 20 cm");
  const JsonValue corner = json.find("corner");
  if (!corner) return;
  const std::string word = text(corner, place, "'corner'");
  if (word != "miter" && word != "mirror" && word != "square")
    place.fail(place.shape, "has an 'allowance' with the unknown corner " + inQuotes(word) +
                                "; write miter, mirror or square");
}

void checkDrillHoles(const JsonValue& json, const PanelUnits& units, const Place& place) {
  std::size_t n = 0;
  for (const JsonValue& item : array(json, place, "'drillHoles'"))
    point(item, numbered(place, "drill hole", n++), "its place", units.cm);
}

}  // namespace

void checkEdgeExtras(const JsonValue& edge, const PanelUnits& units, const Place& place) {
  if (const JsonValue allowance = edge.find("allowance")) checkAllowance(allowance, units, place);
  if (const JsonValue open = edge.find("open")) boolean(open, place, "'open'");
}

GrainLock readGrainLock(const JsonValue& json, const Place& place) {
  const std::string lock = text(json, place, "grain lock");
  if (lock == "free") return GrainLock::kFree;
  if (lock == "on") return GrainLock::kOn;
  if (lock == "across") return GrainLock::kAcross;
  if (lock == "bias") return GrainLock::kBias;
  return place.fail(place.shape, "has an unknown grain lock " + inQuotes(lock) +
                                     "; write free, on, across or bias");
}

double readGrainTolerance(const JsonValue& json, const Place& place) {
  const double degrees = number(json, place, "'toleranceDeg'", 90);
  if (degrees < 0) place.fail(place.number, "has a negative 'toleranceDeg'; write 0 to 90");
  return degrees * kPi / 180;
}

void readExtras(const JsonValue& json, const std::vector<Vec2>& vertices, const PanelUnits& units,
                const Place& place, Panel* panel, std::size_t cubics) {
  if (const JsonValue grain = json.find("grain")) readGrain(grain, units, place, panel);
  if (const JsonValue grains = json.find("grains")) readGrains(grains, units, place, panel);
  if (const JsonValue holes = json.find("holes"))
    readHoles(holes, vertices, units, place, panel, cubics);
  for (const char* key : {"cutLine", "sewLine"})
    if (const JsonValue line = json.find(key)) polyline(line, place, inQuotes(key), units.cm);
  if (const JsonValue lines = json.find("internalLines")) {
    std::size_t n = 0;
    for (const JsonValue& line : array(lines, place, "'internalLines'"))
      polyline(line, numbered(place, "internal line", n++), "its points", units.cm);
  }
  if (const JsonValue folds = json.find("folds")) readFolds(folds, units, place, panel);
  if (const JsonValue drills = json.find("drillHoles")) checkDrillHoles(drills, units, place);
  if (const JsonValue notches = json.find("notches"))
    checkNotches(notches, place, panel->edges.size());
  if (const JsonValue quantity = json.find("quantity"))
    if (integer(quantity, place, "'quantity'") < 1)
      place.fail(place.number, "has a 'quantity' below 1; write how many are cut");
  for (const char* key : {"size", "material"})
    if (const JsonValue words = json.find(key)) text(words, place, inQuotes(key));
}

}  // namespace seamwise
