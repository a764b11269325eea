#include "io/options_json.h"

#include <algorithm>

#include "base/decimal.h"
#include "io/json_input.h"
#include "io/match_json.h"
#include "io/panel_extras_json.h"

namespace seamwise {
namespace {

/// Index of the named piece. An unknown name is a defect and returns 0, which has no effect.
int pieceNamed(const std::string& name, const Garment& garment, const Place& place,
               const std::string& field) {
  const int piece = garment.find(name);
  if (piece < 0)
    return place.fail(place.shape, "names piece " + inQuotes(name) + " in " + field +
                                       ", which the garment has not; correct the name");
  return piece;
}

int checkedSeam(int seam, const Garment& garment, const Place& place, const std::string& field) {
  if (seam < 0 || static_cast<std::size_t>(seam) >= garment.stitches.size())
    place.fail(place.shape, "names seam " + decimal(seam) + " in " + field + ", the garment has " +
                                decimal(garment.stitches.size()) +
                                " (counted from 0); correct the number");
  return seam;
}

int seamNumber(const std::string& key, const Garment& garment, const Place& place) {
  const int number = countOf(key, 9);
  if (number < 0)
    return place.fail(place.shape,
                      "has the key " + inQuotes(key) + " in 'weights'; write a seam number");
  return checkedSeam(number, garment, place, "'weights'");
}

void readGrain(const JsonValue& json, const Garment& garment, const Place& place,
               SolveOptions* options) {
  object(json, place, "'grain'");
  onlyKnown(json, place.in("'grain'"), {"default", "toleranceDeg", "pieces"});
  if (const JsonValue degrees = json.find("toleranceDeg"))
    options->grain.tolerance = readGrainTolerance(degrees, place);
  if (const JsonValue lock = json.find("default")) options->grain.lock = readGrainLock(lock, place);
  const JsonValue pieces = json.find("pieces");
  if (!pieces) return;
  for (const auto& [name, rule_json] : object(pieces, place, "grain.pieces").members()) {
    const int piece = pieceNamed(name, garment, place, "grain.pieces");
    const Place here = place.in("grain of " + inQuotes(name));
    PieceGrain& own = options->piece_grain[piece];
    const auto locked = [&](const JsonValue& lock) {
      own.rule = {readGrainLock(lock, here), options->grain.tolerance};
    };
    if (!rule_json.isObject()) {
      locked(rule_json);
      continue;
    }
    onlyKnown(rule_json, here, {"lock", "toleranceDeg", "angleDeg"});
    if (const JsonValue degrees = rule_json.find("angleDeg"))
      own.line = number(degrees, here, "'angleDeg'", 360) * kPi / 180;
    const JsonValue degrees = rule_json.find("toleranceDeg");
    // A piece may have an angle without a lock.
    if (!own.line || degrees || rule_json.find("lock")) locked(need(rule_json, "lock", here));
    if (degrees) own.rule->tolerance = readGrainTolerance(degrees, here);
  }
}

void readPins(const JsonValue& json, const Garment& garment, const Place& place,
              SolveOptions* options) {
  for (const auto& [name, pin] : object(json, place, "'pins'").members()) {
    const int piece = pieceNamed(name, garment, place, "'pins'");
    const Place here = place.in("pin of " + inQuotes(name));
    object(pin, here, "pin");
    onlyKnown(pin, here, {"angle", "translation"});
    Alignment alignment;
    alignment.angle = number(need(pin, "angle", here), here, "'angle'", 1e3);
    alignment.translation = point(need(pin, "translation", here), here, "'translation'");
    options->pins[piece] = alignment;
  }
}

void readLocked(const JsonValue& json, const Garment& garment, const Place& place,
                SolveOptions* options) {
  for (const auto& [name, edges] : object(json, place, "'locked'").members()) {
    const int piece = pieceNamed(name, garment, place, "'locked'");
    const int count = static_cast<int>(garment.panels[piece].edges.size());
    if (edges.isBoolean()) {
      if (!boolean(edges, place, "'locked' of " + inQuotes(name))) continue;
      for (int edge = 0; edge < count; ++edge) options->locked.push_back({piece, edge});
      continue;
    }
    for (const JsonValue& edge : array(edges, place, "'locked' of " + inQuotes(name))) {
      const int number = integer(edge, place, "an edge in 'locked' of " + inQuotes(name));
      if (number < 0 || number >= count)
        place.fail(place.shape, "locks edge " + decimal(number) + " of piece " + inQuotes(name) +
                                    ", which has " + decimal(count) +
                                    " (counted from 0); correct the number");
      options->locked.push_back({piece, number});
    }
  }
}

OpenEdges readOpenEdges(const JsonValue& json, const Place& place) {
  const std::string word = text(json, place, "'openEdges'");
  if (word == "kept") return OpenEdges::kKept;
  if (word == "free") return OpenEdges::kFree;
  return place.fail(place.shape,
                    "has " + inQuotes(word) + " for 'openEdges'; write \"kept\" or \"free\"");
}

Visibility readVisibility(const JsonValue& json, const Place& place) {
  const std::string word = text(json, place, "'visibility'");
  if (word == "place") return Visibility::kByPlace;
  if (word == "even") return Visibility::kEven;
  return place.fail(place.shape,
                    "has " + inQuotes(word) + " for 'visibility'; write \"place\" or \"even\"");
}

Outcome<SolveOptions> read(const JsonValue& document, const Garment& garment, const Place& place) {
  object(document, place, "content");
  onlyKnown(
      document, place,
      {"$schema",           "format", "maxChangeCm",    "edgeLengthCm", "alpha",  "continuousOnly",
       "averageSeamShapes", "starts", "clipTargets",    "grain",        "pins",   "weights",
       "unmatched",         "plain",  "matches",        "proof",        "locked", "openEdges",
       "visibility",        "effort", "otherAlignments"});
  checkFormat(document, place, "seamwise-options", 1);
  for (const auto& [key, value] : document.members())
    if (value.isNull())
      place.fail(place.shape,
                 "has null for " + inQuotes(key) + "; leave it out or give it a value");
  SolveOptions options;
  const auto real = [&](const char* key) {
    return number(document.find(key), place, inQuotes(key), 1e9);
  };
  const auto flag = [&](const char* key) {
    return boolean(document.find(key), place, inQuotes(key));
  };
  if (document.find("maxChangeCm")) options.max_change_cm = real("maxChangeCm");
  if (document.find("edgeLengthCm")) options.edge_length_cm = real("edgeLengthCm");
  if (document.find("alpha")) options.alpha = real("alpha");
  if (document.find("effort")) options.effort = real("effort");
  if (document.find("proof")) options.proof = real("proof");
  if (document.find("continuousOnly")) options.continuous_only = flag("continuousOnly");
  if (document.find("averageSeamShapes")) options.average_seam_shapes = flag("averageSeamShapes");
  if (const JsonValue starts = document.find("starts"))
    options.starts = integer(starts, place, "'starts'");
  if (document.find("clipTargets")) options.clip_targets = flag("clipTargets");
  if (document.find("otherAlignments")) options.other_alignments = flag("otherAlignments");
  if (const JsonValue grain = document.find("grain")) readGrain(grain, garment, place, &options);
  if (const JsonValue pins = document.find("pins")) readPins(pins, garment, place, &options);
  if (const JsonValue weights = document.find("weights"))
    for (const auto& [key, weight] : object(weights, place, "'weights'").members())
      options.weights[seamNumber(key, garment, place)] =
          number(weight, place, "weight of seam " + key, 1e6);
  if (const JsonValue unmatched = document.find("unmatched"))
    for (const JsonValue& seam : array(unmatched, place, "'unmatched'"))
      options.unmatched.push_back(checkedSeam(integer(seam, place, "a seam of 'unmatched'"),
                                              garment, place, "'unmatched'"));
  if (const JsonValue plain = document.find("plain"))
    for (const JsonValue& name : array(plain, place, "'plain'"))
      options.plain.push_back(
          pieceNamed(text(name, place, "a piece of 'plain'"), garment, place, "'plain'"));
  if (const JsonValue locked = document.find("locked"))
    readLocked(locked, garment, place, &options);
  if (const JsonValue open = document.find("openEdges"))
    options.open_edges = readOpenEdges(open, place);
  if (const JsonValue visibility = document.find("visibility"))
    options.visibility = readVisibility(visibility, place);
  if (const JsonValue matches = document.find("matches"))
    options.matches = readMatches(matches, place, garment);
  const std::string problem = options.problem();
  if (!problem.empty()) return inFile({Failure::kOptions, problem}, place.name);
  return options;
}

}  // namespace

Outcome<SolveOptions> readOptions(std::string_view text, const std::string& file,
                                  const Garment& garment) {
  const Place place{file, Failure::kOptions, Failure::kOptions};
  return readDocument<SolveOptions>(text, place, [&](const JsonValue& document, const Place& here) {
    return read(document, garment, here);
  });
}

}  // namespace seamwise
