#include "io/result_json.h"

#include <nlohmann/json.hpp>

namespace seamwise {
namespace {

using Json = nlohmann::ordered_json;

Json point(const Vec2& p) { return Json::array({p.x(), p.y()}); }

Json points(const std::vector<Vec2>& list) {
  Json out = Json::array();
  for (const Vec2& p : list) out.push_back(point(p));
  return out;
}

Json alignment(const Alignment& a) {
  return {{"angle", a.angle}, {"translation", point(a.translation)}};
}

Json pieceJson(const Result& r, std::size_t p) {
  const Piece& piece = r.pattern.pieces[p];
  return {{"name", piece.name},
          {"rest", points(piece.rest)},
          {"shape", points(r.shapes[p])},
          {"triangles", piece.triangles},
          {"outline", piece.outline},
          {"holes", piece.holes},
          {"alignment", alignment(r.alignment[p])},
          {"mirroredFromInput", piece.mirrored_from_input}};
}

Json seamJson(const Result& r, std::size_t s) {
  const Seam& seam = r.pattern.seams[s];
  auto side = [](const SeamSide& x) { return Json{{"piece", x.piece}, {"vertices", x.vertices}}; };
  return {{"a", side(seam.a)},
          {"b", side(seam.b)},
          {"weight", seam.weight},
          {"matched", seam.matched},
          {"lengthRatio", seam.length_ratio},
          {"kind", r.joins[s].mirrored() ? "mirrored" : "continuous"},
          {"mismatch", r.mismatch[s]}};
}

Json mirrorJson(const Result& r, const Mirror& m) {
  Json out;
  out["kind"] = m.single() ? "piece" : "pair";
  if (m.single())
    out["piece"] = m.pieces[0];
  else
    out["pieces"] = Json::array({m.pieces[0], m.pieces[1]});
  out["map"] = {{"angle", m.map.angle}, {"translation", point(m.map.shift)}};
  Json pairs = Json::array();
  const Piece& piece = r.pattern.pieces[m.pieces[0]];
  for (const auto& loop : loopsOf(piece))
    for (int v : loop) pairs.push_back(Json::array({v, m.image[v]}));
  out["pairs"] = std::move(pairs);
  return out;
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
  out["print"] = {{"group", r.group}, {"w1", point(r.w1)}, {"w2", point(r.w2)}};
  out["pieces"] = Json::array();
  for (std::size_t p = 0; p < r.pattern.pieces.size(); ++p)
    out["pieces"].push_back(pieceJson(r, p));
  out["seams"] = Json::array();
  for (std::size_t s = 0; s < r.pattern.seams.size(); ++s) out["seams"].push_back(seamJson(r, s));
  out["symmetries"] = Json::array();
  for (const Mirror& m : r.pattern.mirrors) out["symmetries"].push_back(mirrorJson(r, m));
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

}  // namespace seamwise
