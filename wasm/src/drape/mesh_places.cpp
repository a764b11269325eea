#include "drape/mesh_places.h"

#include <algorithm>
#include <cmath>

namespace seamwise {
namespace {

constexpr double kInside = -1e-9;   ///< cm, rounding tolerance of points on an edge
constexpr double kLeastCell = 1.0;  ///< cm
constexpr int kMostCells = 200;     ///< per side

}  // namespace

MeshPlaces::MeshPlaces(const Piece& piece) : piece_(&piece) {
  Vec2 high = Vec2::Zero();
  for (std::size_t v = 0; v < piece.rest.size(); ++v) {
    low_ = v == 0 ? piece.rest[v] : Vec2(low_.cwiseMin(piece.rest[v]));
    high = v == 0 ? piece.rest[v] : Vec2(high.cwiseMax(piece.rest[v]));
  }
  const double side = std::max(high.x() - low_.x(), high.y() - low_.y());
  cell_ = std::max(kLeastCell, side / kMostCells);
  columns_ = static_cast<int>((high.x() - low_.x()) / cell_) + 1;
  rows_ = static_cast<int>((high.y() - low_.y()) / cell_) + 1;
  cells_.resize(static_cast<std::size_t>(columns_) * rows_);
  for (std::size_t t = 0; t < piece.triangles.size(); ++t) {
    const auto& [a, b, c] = piece.triangles[t];
    const Vec2 &pa = piece.rest[a], &pb = piece.rest[b], &pc = piece.rest[c];
    const Vec2 from = pa.cwiseMin(pb).cwiseMin(pc), to = pa.cwiseMax(pb).cwiseMax(pc);
    for (int row = rowOf(from.y()); row <= rowOf(to.y()); ++row)
      for (int column = columnOf(from.x()); column <= columnOf(to.x()); ++column)
        cells_[static_cast<std::size_t>(row) * columns_ + column].push_back(static_cast<int>(t));
  }
}

int MeshPlaces::columnOf(double x) const {
  return static_cast<int>(std::clamp((x - low_.x()) / cell_, 0.0, columns_ - 1.0));
}

int MeshPlaces::rowOf(double y) const {
  return static_cast<int>(std::clamp((y - low_.y()) / cell_, 0.0, rows_ - 1.0));
}

double MeshPlaces::depthIn(int triangle, const Vec2& p, std::array<double, 3>& weights) const {
  const auto& corners = piece_->triangles[triangle];
  const double twice = 2 * triangleArea(piece_->rest, corners);
  double least = 0;
  for (int k = 0; k < 3; ++k) {
    const Vec2 &a = piece_->rest[corners[(k + 1) % 3]], &b = piece_->rest[corners[(k + 2) % 3]];
    const double area = cross(b - a, p - a);
    weights[k] = area / twice;
    const Vec2 edge = b - a;
    const double depth = area / std::sqrt(edge.x() * edge.x() + edge.y() * edge.y());
    if (k == 0 || depth < least) least = depth;
  }
  return least;
}

MeshPlace MeshPlaces::at(const Vec2& p) const {
  MeshPlace best;
  double deepest = 0;
  const auto look = [&](int t) {
    std::array<double, 3> weights{};
    const double depth = depthIn(t, p, weights);
    if (best.triangle < 0 || depth > deepest) best = {t, weights}, deepest = depth;
  };
  const int row = rowOf(p.y()), column = columnOf(p.x());
  for (int t : cells_[static_cast<std::size_t>(row) * columns_ + column]) look(t);
  if (best.triangle >= 0 && deepest >= kInside) return best;
  for (std::size_t t = 0; t < piece_->triangles.size(); ++t) look(static_cast<int>(t));
  return best;
}

}  // namespace seamwise
