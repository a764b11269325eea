#include "io/result_json.h"

#include "io/json_output.h"

namespace seamwise {
namespace {

using Json = nlohmann::ordered_json;

Json points(const std::vector<Vec2>& list) {
  Json out = Json::array();
  for (const Vec2& p : list) out.push_back(pointJson(p));
  return out;
}

Json alignment(const Alignment& a) { return motionJson(a.angle, a.translation); }

Json pieceJson(const PrintedPattern& printed, std::size_t p) {
  const Piece& piece = printed.pattern.pieces[p];
  return {{"name", piece.name},
          {"rest", points(piece.rest)},
          {"shape", points(printed.shapes[p])},
          {"triangles", piece.triangles},
          {"outline", piece.outline},
          {"holes", piece.holes},
          {"alignment", alignment(printed.alignment[p])},
          {"mirroredFromInput", piece.mirrored_from_input}};
}

Json seamJson(const PrintedPattern& printed, std::size_t s) {
  const Seam& seam = printed.pattern.seams[s];
  auto side = [](const SeamSide& x) { return Json{{"piece", x.piece}, {"vertices", x.vertices}}; };
  return {{"a", side(seam.a)},
          {"b", side(seam.b)},
          {"weight", seam.weight},
          {"matched", seam.matched},
          {"lengthRatio", seam.length_ratio},
          {"kind", printed.joins[s].mirrored() ? "mirrored" : "continuous"},
          {"mismatch", printed.mismatch[s]}};
}

Json mirrorJson(const PrintedPattern& printed, const Mirror& m) {
  Json out;
  out["kind"] = m.single() ? "piece" : "pair";
  if (m.single())
    out["piece"] = m.pieces[0];
  else
    out["pieces"] = Json::array({m.pieces[0], m.pieces[1]});
  out["map"] = motionJson(m.map.angle, m.map.shift);
  Json pairs = Json::array();
  const Piece& piece = printed.pattern.pieces[m.pieces[0]];
  for (const auto& loop : loopsOf(piece))
    for (int v : loop) pairs.push_back(Json::array({v, m.image[v]}));
  out["pairs"] = std::move(pairs);
  return out;
}

void writePrinted(const PrintedPattern& printed, Json* out) {
  (*out)["print"] = {{"group", printed.group}, {"w1", pointJson(printed.w1)}, {"w2", pointJson(printed.w2)}};
  Json& pieces = (*out)["pieces"] = Json::array();
  for (std::size_t p = 0; p < printed.pattern.pieces.size(); ++p) pieces.push_back(pieceJson(printed, p));
  Json& seams = (*out)["seams"] = Json::array();
  for (std::size_t s = 0; s < printed.pattern.seams.size(); ++s) seams.push_back(seamJson(printed, s));
  Json& symmetries = (*out)["symmetries"] = Json::array();
  for (const Mirror& m : printed.pattern.mirrors) symmetries.push_back(mirrorJson(printed, m));
}

/// The panel's edge that each outline edge is part of; edges follow each other along the outline.
std::vector<int> edgesOf(const Piece& piece) {
  std::vector<int> edges(piece.outline.size());
  const auto& start = piece.edge_start;
  for (std::size_t k = 0, edge = 0; k < edges.size(); ++k) {
    while (edge + 1 < start.size() && start[edge + 1] <= static_cast<int>(k)) ++edge;
    edges[k] = static_cast<int>(edge);
  }
  return edges;
}

const char* methodName(Method method) {
  switch (method) {
    case Method::kPaper:
      return "paper";
    case Method::kWs19:
      return "ws19";
    case Method::kBest:
      break;
  }
  return "best";
}

}  // namespace

std::string writeResult(const Result& r) {
  Json out;
  out["format"] = "seamwise-result/1";
  out["units"] = "cm";
  writePrinted(r, &out);
  out["search"] = Json::array();
  for (const Alignment& a : r.search) out["search"].push_back(alignment(a));
  out["metrics"] = {{"method", methodName(r.method)},
                    {"seed", r.seed},
                    {"fitRandom", r.fit_random},
                    {"fitSearch", r.fit_search},
                    {"fitAligned", r.fit_aligned},
                    {"fit", r.fit.any},
                    {"fitStrict", r.fit.strict},
                    {"fitSeam", r.fit.seam},
                    {"maxMovedCm", r.max_moved_cm},
                    {"iterations", r.iterations},
                    {"factorisations", r.factorisations},
                    {"milliseconds", {{"alignment", 0}, {"deformation", 0}, {"total", 0}}}};
  out["notes"] = r.notes;
  return out.dump();
}

std::string writePattern(const PrintedPattern& printed) {
  Json out;
  writePrinted(printed, &out);
  for (std::size_t p = 0; p < printed.pattern.pieces.size(); ++p)
    out["pieces"][p]["edges"] = edgesOf(printed.pattern.pieces[p]);
  out["fitRandom"] = printed.fit_random;
  out["notes"] = printed.notes;
  return out.dump();
}

}  // namespace seamwise
