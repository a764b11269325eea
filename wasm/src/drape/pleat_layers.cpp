#include "drape/pleat_layers.h"

#include <algorithm>
#include <cmath>

namespace seamwise {
namespace {

constexpr double kJoined = 1;         ///< cm, greatest distance between both sides of a join
constexpr double kBesideJoin = 0.02;  ///< cm, distance of a place that belongs to one side of it

/// Returns the fabric beside closed pleats that is at a distance across the folded piece: one place
/// or, at a join, two. The result is empty in open pleats.
std::vector<double> besideAt(const std::vector<UprightPleat>& pleats, const PleatedPoint& folded,
                             double y, double open) {
  double shift = 0;
  for (const UprightPleat& pleat : pleats) {
    const double width = pleat.widthAt(y), left = pleat.leftAt(y) + shift;
    const double gap = pleat.gapAt(y, open);
    if (!(width > 0)) continue;
    const double x = folded.across - shift;
    if (gap < kJoined && folded.across > left - kBesideJoin &&
        folded.across < left + gap + kBesideJoin)
      return {pleat.leftAt(y) - kBesideJoin, pleat.leftAt(y) + width + kBesideJoin};
    if (folded.across <= left) return {x};
    if (folded.across < left + gap) return {};
    shift += gap - width;
  }
  return {folded.across - shift};
}

}  // namespace

PleatLayers::PleatLayers(const Pattern& pattern) : pattern_(pattern) {
  for (const Piece& piece : pattern.pieces) {
    covered_.emplace_back(piece.rest.size(), 0);
    sewn_.emplace_back(piece.rest.size(), 0);
  }
  for (const Seam& seam : pattern.seams)
    for (const SeamSide* side : {&seam.a, &seam.b})
      for (const int v : side->vertices) sewn_[side->piece][v] = 1;
}

void PleatLayers::add(int piece, const std::vector<Vec2>& flat,
                      const std::vector<UprightPleat>& pleats, const std::vector<double>& opened) {
  Piece turned = pattern_.pieces[piece];
  turned.rest = flat;
  const MeshPlaces places(turned);
  for (std::size_t v = 0; v < flat.size(); ++v) {
    const PleatedPoint folded = closedAt(pleats, flat[v], opened[v]);
    if (sewn_[piece][v] || std::abs(folded.layer) < 0.75) continue;
    Laid laid{piece, static_cast<int>(v), {}, folded.layer};
    for (const double x : besideAt(pleats, folded, flat[v].y(), opened[v]))
      laid.on.push_back(places.at({x, flat[v].y()}));
    if (laid.on.empty()) continue;
    covered_[piece][v] = 1;
    laid_.push_back(std::move(laid));
  }
}

void PleatLayers::lay(PiecePositions* positions) const {
  std::vector<std::vector<Vec3>> normals(pattern_.pieces.size());
  for (const Laid& laid : laid_) {
    std::vector<Vec3>& x = (*positions)[laid.piece];
    std::vector<Vec3>& outwards = normals[laid.piece];
    const Piece& piece = pattern_.pieces[laid.piece];
    const std::vector<char>& covered = covered_[laid.piece];
    if (outwards.empty()) {
      outwards.assign(x.size(), Vec3::Zero());
      for (const auto& t : piece.triangles) {
        if (covered[t[0]] || covered[t[1]] || covered[t[2]]) continue;
        const Vec3 normal = crossProduct(x[t[1]] - x[t[0]], x[t[2]] - x[t[0]]);
        for (const int v : t) outwards[v] += normal;
      }
    }
    Vec3 at = Vec3::Zero(), normal = Vec3::Zero();
    for (const MeshPlace& place : laid.on)
      for (int k = 0; k < 3; ++k) {
        const int corner = piece.triangles[place.triangle][k];
        at += place.weights[k] / static_cast<double>(laid.on.size()) * x[corner];
        normal += std::max(0.0, place.weights[k]) * outwards[corner];
      }
    const double far = length(normal);
    x[laid.vertex] = far > 0 ? Vec3(at + normal * (laid.layer * kPleatLayer / far)) : at;
  }
}

}  // namespace seamwise
