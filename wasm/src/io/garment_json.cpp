#include "io/garment_json.h"

#include <algorithm>

#include "base/decimal.h"
#include "io/match_json.h"
#include "io/panel_json.h"
#include "io/stitch_json.h"
#include "io/symmetry_json.h"

namespace seamwise {
namespace {

constexpr std::size_t kMaxPanels = 2000;
constexpr double kSmallestPieceCm = 1, kLargestPieceCm = 1000;

struct Units {
  PanelUnits panel;
  double per_metre = 100;
  bool stated = false;
};

Units readUnits(const JsonValue& document, const Place& place) {
  Units units;
  const JsonValue properties = document.find("properties");
  if (properties) object(properties, place, "'properties'");
  if (const JsonValue stated = properties.find("units_in_meter")) {
    Place here = place;
    here.number = Failure::kUnits;
    units.stated = true;
    units.per_metre = number(stated, here, "properties.units_in_meter", 1e9);
    if (!(units.per_metre >= 1e-6))
      place.fail(Failure::kUnits, "has " + shown(units.per_metre) +
                                      " as properties.units_in_meter; write how many units make a "
                                      "metre (100 for cm, 1000 for mm)");
  }
  units.panel.cm = 100 / units.per_metre;
  if (const JsonValue coords = properties.find("curvature_coords")) {
    const std::string word = text(coords, place, "properties.curvature_coords");
    if (word != "relative" && word != "absolute")
      place.fail(
          Failure::kCurvature,
          "has " + inQuotes(word) + " as properties.curvature_coords; write relative or absolute");
    units.panel.absolute_controls = word == "absolute";
  }
  return units;
}

struct Extent {
  double cm = 0;
  std::string panel;
};

/// The greatest width or height of a panel of the file.
Extent largestExtent(const JsonValue& panels, double cm) {
  Extent largest;
  for (const auto& [name, panel] : panels.members()) {
    const JsonValue vertices = panel.find("vertices");
    if (!vertices.isList()) continue;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      double low = HUGE_VAL, high = -HUGE_VAL;
      for (const JsonValue& v : vertices.items()) {
        if (!v.isList() || v.size() != 2 || !v[axis].isNumber()) continue;
        low = std::min(low, v[axis].number());
        high = std::max(high, v[axis].number());
      }
      if ((high - low) * cm > largest.cm) largest = {(high - low) * cm, name};
    }
  }
  return largest;
}

/// Wrong units are the likeliest cause of a far too small or too large garment. This check precedes
/// the reading of panels, whose limits would cause a less clear message.
void checkSize(const JsonValue& panels, const Units& units, const Place& place) {
  const auto [extent, panel] = largestExtent(panels, units.panel.cm);
  if (extent <= 0 || (extent >= kSmallestPieceCm && extent <= kLargestPieceCm)) return;
  std::string likely;
  for (const auto& [per_metre, name] : likelyUnits(extent, units.per_metre))
    likely += (likely.empty() ? "" : " or ") + shown(per_metre) + " (" + name + ")";
  place.fail(Failure::kUnits,
             "has a largest panel, " + inQuotes(panel) + ", of " + shown(extent) + " cm with " +
                 (units.stated ? "properties.units_in_meter " + shown(units.per_metre)
                               : "the 100 units per metre assumed because it states none") +
                 (likely.empty()
                      ? "; correct its vertices, or set properties.units_in_meter to what makes "
                        "a metre"
                      : "; set properties.units_in_meter, probably to " + likely));
}

bool anyCurve(const JsonValue& panels) {
  for (const auto& [name, panel] : panels.members())
    for (const JsonValue& edge : panel.find("edges").items())
      if (edge.find("curvature")) return true;
  return false;
}

void noteAssumptions(const JsonValue& document, const Units& units, const JsonValue& panels,
                     const std::string& file, std::vector<Note>* notes) {
  if (!units.stated)
    notes->push_back(
        {"unitsAssumed", file + " states no units, so 100 units per metre (cm) are assumed."});
  const JsonValue properties = document.find("properties");
  if (!properties.find("curvature_coords") && anyCurve(panels))
    notes->push_back({"curvesAssumed",
                      file + " does not say how curves are written, so relative control points are "
                             "assumed."});
}

/// Reads the size and the body measurements. A solve does not use them, so they cause no error.
void readWearer(const JsonValue& document, Garment* garment) {
  garment->size = document.find("size").text();
  for (const auto& [name, value] : document.find("body").members())
    if (value.isNumber()) garment->body.push_back({name, value.number()});
}

JsonValue panelsOf(const JsonValue& document, const Place& place) {
  if (!document.isObject())
    return place.fail(Failure::kNotAGarment, "holds no JSON object; choose a garment file");
  checkFormat(document, place, "seamwise-garment", 1);
  const JsonValue panels = document.find("pattern").find("panels");
  if (!panels)
    return place.fail(
        Failure::kNotAGarment,
        "has no 'pattern' with 'panels'; choose a GarmentCode specification or a seamwise garment");
  if (!panels.isObject())
    return place.fail(
        Failure::kNotAGarment,
        "has 'panels' that are no object; write {\"name\": {\"vertices\": ..., \"edges\": ...}}");
  if (panels.size() == 0)
    return place.fail(Failure::kNoPanels, "has no panels; choose a file with some");
  if (panels.size() > kMaxPanels)
    return place.fail(Failure::kTooLarge,
                      "has more than " + decimal(kMaxPanels) + " panels; split it");
  return panels;
}

}  // namespace

std::vector<LengthUnit> likelyUnits(double extent_cm, double per_metre) {
  std::vector<LengthUnit> likely;
  for (const LengthUnit& unit :
       {LengthUnit{100, "cm"}, {1000, "mm"}, {100 / 2.54, "inch"}, {1, "m"}})
    if (isWearable(extent_cm * per_metre / unit.per_metre)) likely.push_back(unit);
  return likely;
}

bool isWearable(double height_cm) {
  constexpr double kBib = 14, kTrain = 260;  // cm: a baby's bib, a bridal train
  return height_cm >= kBib && height_cm <= kTrain;
}

GarmentFile readGarmentFile(const JsonValue& document, const Place& place) {
  GarmentFile result;
  const JsonValue panels = panelsOf(document, place);
  const Units units = readUnits(document, place);
  result.unit_cm = units.panel.cm;
  if (!place.failed()) checkSize(panels, units, place);

  Garment& garment = result.garment;
  for (const auto& [name, panel] : panels.members()) {
    if (place.failed()) return result;
    Place here = place.in("panel " + inQuotes(name));
    here.piece = static_cast<int>(garment.panels.size());
    garment.panels.push_back(readPanel(name, panel, units.panel, here));
  }
  if (place.failed()) return result;
  if (const JsonValue stitches = document.find("pattern").find("stitches"))
    readStitches(stitches, place, &garment);
  if (const JsonValue seams = document.find("seams"))
    readSeams(seams, place, &garment, &result.notes);
  if (const JsonValue matches = document.find("matches"))
    garment.matches = readMatches(matches, place, garment);
  if (const JsonValue symmetries = document.find("symmetries")) {
    Place here = place;
    here.shape = here.number = Failure::kSymmetryMalformed;
    result.symmetries = readSymmetryList(symmetries, here);
  }
  readWearer(document, &garment);
  noteAssumptions(document, units, panels, place.name, &result.notes);
  return result;
}

Place garmentPlace(const std::string& file) {
  Place place{file, Failure::kNotAGarment, Failure::kNumber};
  place.keeps_unknown = true;
  return place;
}

Outcome<GarmentFile> readGarment(std::string_view text, const std::string& file) {
  return readDocument<GarmentFile>(text, garmentPlace(file), readGarmentFile);
}

}  // namespace seamwise
