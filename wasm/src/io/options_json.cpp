#include "io/options_json.h"

#include <algorithm>

#include "io/json_input.h"
#include "io/match_json.h"
#include "io/panel_extras_json.h"

namespace seamwise {
namespace {

int pieceNamed(const std::string& name, const Garment& garment, const Place& place,
               const std::string& field) {
  const int piece = garment.find(name);
  if (piece < 0)
    place.fail(place.shape, "names piece " + inQuotes(name) + " in " + field +
                                ", which the garment has not; correct the name");
  return piece;
}

int checkedSeam(int seam, const Garment& garment, const Place& place, const std::string& field) {
  if (seam < 0 || static_cast<std::size_t>(seam) >= garment.stitches.size())
    place.fail(place.shape, "names seam " + std::to_string(seam) + " in " + field +
                                ", the garment has " + std::to_string(garment.stitches.size()) +
                                " (counted from 0); correct the number");
  return seam;
}

int seamNumber(const std::string& key, const Garment& garment, const Place& place) {
  const bool digits =
      !key.empty() && key.size() <= 9 &&
      std::all_of(key.begin(), key.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (!digits)
    place.fail(place.shape, "has the key " + inQuotes(key) + " in 'weights'; write a seam number");
  return checkedSeam(std::stoi(key), garment, place, "'weights'");
}

void readGrain(const Json& json, const Garment& garment, const Place& place,
               SolveOptions* options) {
  object(json, place, "'grain'");
  onlyKnown(json, place.in("'grain'"), {"default", "toleranceDeg", "pieces"});
  if (const Json* degrees = find(json, "toleranceDeg"))
    options->grain.tolerance = readGrainTolerance(*degrees, place);
  if (const Json* lock = find(json, "default")) options->grain.lock = readGrainLock(*lock, place);
  const Json* pieces = find(json, "pieces");
  if (!pieces) return;
  for (const auto& [name, rule_json] : object(*pieces, place, "grain.pieces").items()) {
    const int piece = pieceNamed(name, garment, place, "grain.pieces");
    const Place here = place.in("grain of " + inQuotes(name));
    PieceGrain& own = options->piece_grain[piece];
    const auto locked = [&](const Json& lock) {
      own.rule = {readGrainLock(lock, here), options->grain.tolerance};
    };
    if (!rule_json.is_object()) {
      locked(rule_json);
      continue;
    }
    onlyKnown(rule_json, here, {"lock", "toleranceDeg", "angleDeg"});
    if (const Json* degrees = find(rule_json, "angleDeg"))
      own.line = number(*degrees, here, "'angleDeg'", 360) * kPi / 180;
    const Json* degrees = find(rule_json, "toleranceDeg");
    // where the line runs may be said without a word on how it lies
    if (!own.line || degrees || find(rule_json, "lock")) locked(need(rule_json, "lock", here));
    if (degrees) own.rule->tolerance = readGrainTolerance(*degrees, here);
  }
}

void readPins(const Json& json, const Garment& garment, const Place& place, SolveOptions* options) {
  for (const auto& [name, pin] : object(json, place, "'pins'").items()) {
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

void readLocked(const Json& json, const Garment& garment, const Place& place,
                SolveOptions* options) {
  for (const auto& [name, edges] : object(json, place, "'locked'").items()) {
    const int piece = pieceNamed(name, garment, place, "'locked'");
    const int count = static_cast<int>(garment.panels[piece].edges.size());
    if (edges.is_boolean()) {
      if (!boolean(edges, place, "'locked' of " + inQuotes(name))) continue;
      for (int edge = 0; edge < count; ++edge) options->locked.push_back({piece, edge});
      continue;
    }
    for (const Json& edge : array(edges, place, "'locked' of " + inQuotes(name))) {
      const int number = integer(edge, place, "an edge in 'locked' of " + inQuotes(name));
      if (number < 0 || number >= count)
        place.fail(place.shape, "locks edge " + std::to_string(number) + " of piece " +
                                    inQuotes(name) + ", which has " + std::to_string(count) +
                                    " (counted from 0); correct the number");
      options->locked.push_back({piece, number});
    }
  }
}

OpenEdges readOpenEdges(const Json& json, const Place& place) {
  const std::string word = text(json, place, "'openEdges'");
  if (word == "kept") return OpenEdges::kKept;
  if (word == "free") return OpenEdges::kFree;
  place.fail(place.shape, "has " + inQuotes(word) + " for 'openEdges'; write \"kept\" or \"free\"");
}

SolveOptions read(std::string_view content, const Garment& garment, const Place& place) {
  const Json document = parseDocument(content, place);
  object(document, place, "content");
  onlyKnown(document, place,
            {"$schema", "format", "maxChangeCm", "edgeLengthCm", "alpha", "continuousOnly",
             "averageSeamShapes", "starts", "clipTargets", "grain", "pins", "weights", "unmatched",
             "plain", "matches", "proof", "locked", "openEdges", "effort"});
  checkFormat(document, place, "seamwise-options", 1);
  for (const auto& [key, value] : document.items())
    if (value.is_null())
      place.fail(place.shape,
                 "has null for " + inQuotes(key) + "; leave it out or give it a value");
  SolveOptions options;
  const auto real = [&](const char* key) {
    return number(document[key], place, inQuotes(key), 1e9);
  };
  const auto flag = [&](const char* key) { return boolean(document[key], place, inQuotes(key)); };
  if (find(document, "maxChangeCm")) options.max_change_cm = real("maxChangeCm");
  if (find(document, "edgeLengthCm")) options.edge_length_cm = real("edgeLengthCm");
  if (find(document, "alpha")) options.alpha = real("alpha");
  if (find(document, "effort")) options.effort = real("effort");
  if (find(document, "proof")) options.proof = real("proof");
  if (find(document, "continuousOnly")) options.continuous_only = flag("continuousOnly");
  if (find(document, "averageSeamShapes")) options.average_seam_shapes = flag("averageSeamShapes");
  if (const Json* starts = find(document, "starts"))
    options.starts = integer(*starts, place, "'starts'");
  if (find(document, "clipTargets")) options.clip_targets = flag("clipTargets");
  if (const Json* grain = find(document, "grain")) readGrain(*grain, garment, place, &options);
  if (const Json* pins = find(document, "pins")) readPins(*pins, garment, place, &options);
  if (const Json* weights = find(document, "weights"))
    for (const auto& [key, weight] : object(*weights, place, "'weights'").items())
      options.weights[seamNumber(key, garment, place)] =
          number(weight, place, "weight of seam " + key, 1e6);
  if (const Json* unmatched = find(document, "unmatched"))
    for (const Json& seam : array(*unmatched, place, "'unmatched'"))
      options.unmatched.push_back(checkedSeam(integer(seam, place, "a seam of 'unmatched'"),
                                              garment, place, "'unmatched'"));
  if (const Json* plain = find(document, "plain"))
    for (const Json& name : array(*plain, place, "'plain'"))
      options.plain.push_back(
          pieceNamed(text(name, place, "a piece of 'plain'"), garment, place, "'plain'"));
  if (const Json* locked = find(document, "locked")) readLocked(*locked, garment, place, &options);
  if (const Json* open = find(document, "openEdges"))
    options.open_edges = readOpenEdges(*open, place);
  if (const Json* matches = find(document, "matches"))
    options.matches = readMatches(*matches, place, garment);
  const std::string problem = options.problem();
  if (!problem.empty()) throw InputError{inFile({Failure::kOptions, problem}, place.name)};
  return options;
}

}  // namespace

Outcome<SolveOptions> readOptions(std::string_view text, const std::string& file,
                                  const Garment& garment) {
  const Place place{file, Failure::kOptions, Failure::kOptions};
  return guarded<SolveOptions>(place, [&] { return read(text, garment, place); });
}

}  // namespace seamwise
