#include "io/symmetry_json.h"

namespace seamwise {
namespace {

SymmetryRequest readPair(const Json& json, const Place& place) {
  onlyKnown(json, place, {"kind", "pieces"});
  const Json& pieces = need(json, "pieces", place);
  if (!pieces.is_array() || pieces.size() != 2)
    place.fail(place.shape, "has no two 'pieces'; write [\"one\", \"other\"]");
  PairRequest pair{text(pieces[0], place, "a piece"), text(pieces[1], place, "a piece")};
  if (pair.first == pair.second)
    place.fail(place.shape, "pairs " + inQuotes(pair.first) +
                                " with itself; name two pieces or use the kind 'piece'");
  return pair;
}

SymmetryRequest readSingle(const Json& json, const Place& place) {
  onlyKnown(json, place, {"kind", "piece", "axis", "seams"});
  const std::string piece = text(need(json, "piece", place), place, "'piece'");
  const Json* axis = find(json, "axis");
  const Json* edges = find(json, "seams");
  if (axis && edges) place.fail(place.shape, "has both 'axis' and 'seams'; keep one");
  if (axis) {
    const Polyline ends = polyline(*axis, place, "'axis'");
    if (ends.size() != 2 || !((ends[1] - ends[0]).norm() > 1e-3))
      place.fail(place.shape, "needs an 'axis' of two distinct points; correct it");
    return AxisRequest{piece, ends[0], ends[1]};
  }
  if (edges) {
    if (!edges->is_array() || edges->size() != 2)
      place.fail(place.shape, "needs two edge numbers as 'seams'; correct it");
    EdgesRequest request{piece, integer((*edges)[0], place, "an edge"),
                         integer((*edges)[1], place, "an edge")};
    if (request.first < 0 || request.second < 0)
      place.fail(place.shape, "has a negative edge number in 'seams'; correct it");
    return request;
  }
  return PieceRequest{piece};
}

}  // namespace

std::vector<SymmetryRequest> readSymmetryList(const Json& json, const Place& outer) {
  array(json, outer, "'symmetries'");
  std::vector<SymmetryRequest> requests;
  for (std::size_t n = 0; n < json.size(); ++n) {
    const Place place = numbered(outer, "symmetry", n);
    object(json[n], place, "symmetry");
    const std::string kind = text(need(json[n], "kind", place), place, "'kind'");
    if (kind == "pair")
      requests.push_back(readPair(json[n], place));
    else if (kind == "piece")
      requests.push_back(readSingle(json[n], place));
    else
      place.fail(place.shape, "is of the unknown kind " + inQuotes(kind) + "; write piece or pair");
  }
  return requests;
}

Outcome<std::vector<SymmetryRequest>> readSymmetries(std::string_view text,
                                                     const std::string& file) {
  const Place place{file, Failure::kSymmetryMalformed, Failure::kSymmetryMalformed};
  return guarded<std::vector<SymmetryRequest>>(place, [&] {
    const Json document = parseDocument(text, place);
    object(document, place, "content");
    onlyKnown(document, place, {"$schema", "format", "symmetries"});
    checkFormat(document, place, "seamwise-symmetries", 1);
    return readSymmetryList(need(document, "symmetries", place), place);
  });
}

}  // namespace seamwise
