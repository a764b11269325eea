#include "drape/hung_garment.h"

#include <algorithm>
#include <utility>

#include "base/disjoint_sets.h"

namespace seamwise {
namespace {

constexpr double kFarthestShoulder = 23;   ///< cm, from the middle
constexpr double kUnderShoulders = 128.8;  ///< cm, minimum height of shoulder seams in files

}  // namespace

HungGarment::HungGarment(const Garment& garment, const Pattern& pattern, const Form& form,
                         const Hanging& hanging)
    : pattern_(pattern), hanging_(hanging) {
  for (int part = 0; part < kBodyParts; ++part)
    girths_[part] = wornGirths(garment, pattern, form, static_cast<BodyPart>(part));
  sewn_.resize(pattern.pieces.size());
  for (std::size_t p = 0; p < sewn_.size(); ++p)
    sewn_[p].assign(pattern.pieces[p].rest.size(), false);
  for (const Seam& seam : pattern.seams)
    for (const SeamSide* side : {&seam.a, &seam.b})
      for (int v : side->vertices) sewn_[side->piece][v] = true;
  for (std::size_t p = 0; p < pattern.pieces.size(); ++p)
    for (int v : pattern.pieces[p].outline) top_ = std::max(top_, at(static_cast<int>(p), v).y());
  if (const std::optional<double> rise = wornRise(garment, pattern, form)) crotch_ = top_ - *rise;
  findShoulders();
  findTop();
}

Vec3 HungGarment::at(int piece, int vertex) const {
  return hanging_.placed[piece](pattern_.pieces[piece].rest[vertex]);
}

// Finds where the shoulder seams start and end, measured from the middle.
void HungGarment::findShoulders() {
  double highest = -1e9;
  std::vector<std::pair<double, double>> seams;
  for (double x = 4; x < kFarthestShoulder; x += 0.5)
    for (const double side : {x, -x})
      if (const std::optional<double> top = topOver(side, true); top && *top > kUnderShoulders)
        seams.emplace_back(x, *top), highest = std::max(highest, *top);
  constexpr double kSlope = 12;  // cm, maximum fall of shoulders
  for (const auto& [x, top] : seams)
    if (top > highest - kSlope) neck_ = std::min(neck_, x), shoulder_ = std::max(shoulder_, x);
}

// Finds the top edge of a garment around its body part: a chain of open edges that continues across
// seams.
void HungGarment::findTop() {
  std::vector<int> first;
  int count = 0;
  for (const Piece& piece : pattern_.pieces)
    first.push_back(count), count += static_cast<int>(piece.rest.size());
  DisjointSets knots(count);
  for (const Seam& seam : pattern_.seams)
    for (std::size_t i = 0; i < seam.a.vertices.size(); ++i)
      knots.join(first[seam.a.piece] + seam.a.vertices[i],
                 first[seam.b.piece] + seam.b.vertices[i]);
  const std::vector<std::vector<char>> sewn = sewnEdges(pattern_);
  struct Edge {
    int knot;
    double length, low, high;
  };
  std::vector<Edge> edges;
  for (std::size_t p = 0; p < pattern_.pieces.size(); ++p) {
    const BodyPart part = hanging_.parts[p];
    const std::vector<int>& outline = pattern_.pieces[p].outline;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const int u = outline[i], v = outline[(i + 1) % outline.size()];
      if (sewn[p][i]) continue;
      knots.join(first[p] + u, first[p] + v);
      if (part != BodyPart::kTorso && !(only(part) & kLegs)) continue;
      const Vec3 a = at(static_cast<int>(p), u), b = at(static_cast<int>(p), v);
      edges.push_back(
          {first[p] + u, length(Vec3(b - a)), std::min(a.y(), b.y()), std::max(a.y(), b.y())});
    }
  }
  int highest = -1;
  for (const Edge& edge : edges)
    if (edge.high > top_ - 1e-9 || highest < 0) {
      highest = knots.find(edge.knot);
      if (edge.high > top_ - 1e-9) break;
    }
  top_low_ = top_;
  for (const Edge& edge : edges)
    if (knots.find(edge.knot) == highest)
      top_girth_ += edge.length, top_low_ = std::min(top_low_, edge.low);
}

bool HungGarment::hasCollar() const {
  return std::find(hanging_.parts.begin(), hanging_.parts.end(), BodyPart::kNeck) !=
         hanging_.parts.end();
}

std::optional<double> HungGarment::topOver(double x, bool sewn_only) const {
  double top = -1e9;
  bool sewn = false;
  for (std::size_t p = 0; p < pattern_.pieces.size(); ++p) {
    if (hanging_.parts[p] != BodyPart::kTorso) continue;
    const std::vector<int>& outline = pattern_.pieces[p].outline;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const int u = outline[i], v = outline[(i + 1) % outline.size()];
      const Vec3 a = at(static_cast<int>(p), u), b = at(static_cast<int>(p), v);
      if ((a.x() < x) == (b.x() < x)) continue;
      const double height = a.y() + (x - a.x()) / (b.x() - a.x()) * (b.y() - a.y());
      if (height > top) top = height, sewn = sewn_[p][u] && sewn_[p][v];
    }
  }
  return top > -1e9 && (sewn || !sewn_only) ? std::optional(top) : std::nullopt;
}

}  // namespace seamwise
