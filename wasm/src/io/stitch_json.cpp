#include "io/stitch_json.h"

#include <map>
#include <set>
#include <utility>

#include "base/decimal.h"

namespace seamwise {
namespace {

EdgeRef readSide(const JsonValue& json, const Place& place, const Garment& garment) {
  const JsonValue panel = json.find("panel");
  const JsonValue edge = json.find("edge");
  if (!panel || !edge)
    return place.fail(Failure::kSeamMalformed,
                      "has a malformed side; write {\"panel\": \"name\", \"edge\": number}");
  Place here = place;
  here.shape = Failure::kSeamMalformed;
  const std::string name = text(panel, here, "'panel'");
  const int piece = garment.find(name);
  if (piece < 0)
    return place.fail(Failure::kSeamUnknownPiece, "names panel " + inQuotes(name) +
                                                      ", which the file has not; correct the name");
  here.piece = piece;
  const int number = integer(edge, here, "'edge'");
  const std::size_t edges = garment.panels[static_cast<std::size_t>(piece)].edges.size();
  if (number < 0 || static_cast<std::size_t>(number) >= edges)
    here.fail(Failure::kSeamUnknownEdge,
              "names edge " + decimal(number) + " of panel " + inQuotes(name) + ", which has " +
                  decimal(edges) + " (0 to " + decimal(edges - 1) + "); correct the number");
  return {piece, number};
}

}  // namespace

void readStitches(const JsonValue& stitches, const Place& outer, Garment* garment) {
  std::map<std::pair<int, int>, std::size_t> used;  // edge -> stitch
  for (const JsonValue& sides : array(stitches, outer, "'stitches'")) {
    const std::size_t n = garment->stitches.size();
    Place place = numbered(outer, "stitch", n);
    place.seam = static_cast<int>(n);
    if (!sides.isList() || sides.size() < 2 || sides.size() > 3)
      place.fail(Failure::kSeamMalformed,
                 "is not a list of two sides (and \"right_wrong\"); correct it");
    Stitch stitch{readSide(sides[0], place, *garment), readSide(sides[1], place, *garment)};
    if (sides.size() == 3 && !sides[2].isNull()) {
      if (sides[2].kind() != JsonKind::kText || sides[2].text() != "right_wrong")
        place.fail(Failure::kSeamMalformed,
                   "has an unknown third element; write \"right_wrong\" or leave it out");
      stitch.same_direction = true;
    }
    if (place.failed()) return;
    for (const EdgeRef& side : {stitch.a, stitch.b}) {
      const auto [earlier, fresh] = used.emplace(std::pair(side.piece, side.edge), n);
      if (fresh) continue;
      place.piece = side.piece;
      const std::string edge = "edge " + decimal(side.edge) + " of panel " +
                               inQuotes(garment->panels[static_cast<std::size_t>(side.piece)].name);
      place.fail(Failure::kSeamEdgeTwice,
                 earlier->second == n
                     ? "sews " + edge + " to itself; name two edges"
                     : "sews " + edge + ", which stitch " + decimal(earlier->second) +
                           " already sews; split the edge or remove one stitch");
      return;
    }
    garment->stitches.push_back(stitch);
  }
}

void readSeams(const JsonValue& seams, const Place& outer, Garment* garment,
               std::vector<Note>* notes) {
  Place listed = outer;
  listed.shape = Failure::kSeamMalformed;
  std::set<int> described;
  std::size_t k = 0;
  for (const JsonValue& seam : array(seams, listed, "'seams'")) {
    Place place = numbered(listed, "seam", k++);
    object(seam, place, "seam");
    const int n = integer(need(seam, "stitch", place), place, "'stitch'");
    if (n < 0 || static_cast<std::size_t>(n) >= garment->stitches.size()) {
      place.fail(Failure::kSeamMalformed, "describes stitch " + decimal(n) + ", the file has " +
                                              decimal(garment->stitches.size()) +
                                              "; correct the number");
      return;
    }
    place.seam = n;
    if (!described.insert(n).second)
      place.fail(Failure::kSeamMalformed,
                 "describes stitch " + decimal(n) + " a second time; remove one entry");
    Stitch& stitch = garment->stitches[static_cast<std::size_t>(n)];
    if (const JsonValue name = seam.find("name")) text(name, place, "'name'");
    if (const JsonValue suggested = seam.find("suggested"))
      boolean(suggested, place, "'suggested'");
    if (const JsonValue weight = seam.find("weight")) {
      stitch.weight = number(weight, place, "'weight'", 1e6);
      if (stitch.weight < 0) place.fail(Failure::kNumber, "has a negative weight; write 0 or more");
    }
    if (const JsonValue matched = seam.find("matched"))
      stitch.matched = boolean(matched, place, "'matched'");
    if (const JsonValue direction = seam.find("direction")) {
      const std::string word = text(direction, place, "'direction'");
      if (word != (stitch.same_direction ? "same" : "opposite"))
        place.fail(Failure::kSeamMalformed, "has the direction " + inQuotes(word) +
                                                ", its stitch says '" +
                                                (stitch.same_direction ? "same" : "opposite") +
                                                "'; add or remove \"right_wrong\" there");
    }
    if (const JsonValue stated = seam.find("lengthRatio")) {
      const double ratio = number(stated, place, "'lengthRatio'", 1e4);
      if (!(ratio > 0)) place.fail(Failure::kNumber, "has no positive 'lengthRatio'; correct it");
      const auto length = [&](const EdgeRef& side) {
        return garment->panels[static_cast<std::size_t>(side.piece)]
            .edges[static_cast<std::size_t>(side.edge)]
            .length();
      };
      const double drafted = length(stitch.a) / length(stitch.b);
      if (std::abs(ratio / drafted - 1) > 0.02)
        notes->push_back({"lengthRatio",
                          place.name + " states the length ratio " + shown(ratio) +
                              ", its edges are drafted " + shown(drafted) +
                              "; the drafted ratio is used.",
                          {},
                          {n},
                          {ratio, drafted}});
    }
  }
}

}  // namespace seamwise
