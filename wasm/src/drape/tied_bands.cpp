#include "drape/tied_bands.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/sort_by.h"
#include "drape/ring.h"

namespace seamwise {
namespace {

constexpr double kTallestTied = 15;  ///< cm, maximum height of a band
constexpr double kLeastEnd = 10;     ///< cm, minimum length of an end beyond the knot
constexpr double kKnot = 4;          ///< cm, length along both edges
constexpr double kLevel = 0.3;       ///< cm, tolerance of a level straight edge
constexpr double kAlike = 0.3;       ///< cm, maximum difference between both ends

/// Returns the vertices of the lower edge that are sewn in the knot, outwards from its start.
std::vector<int> knotted(const Piece& piece, const std::vector<Vec2>& flat, double bottom,
                         double middle, double from, int side) {
  std::vector<std::pair<double, int>> at;
  for (const int v : piece.outline) {
    const double out = side * (flat[v].x() - middle);
    if (flat[v].y() - bottom < kLevel && out >= from && out <= from + kKnot)
      at.emplace_back(out, v);
  }
  sortBy(at, [](const auto& one) { return one.first; });
  std::vector<int> vertices;
  vertices.reserve(at.size());
  for (const auto& [out, v] : at) vertices.push_back(v);
  return vertices;
}

}  // namespace

void tieBands(const Hanging& hanging, const Form& form, Pattern* pattern) {
  const Tube& torso = form.tube(BodyPart::kTorso);
  for (int p = 0; p < static_cast<int>(pattern->pieces.size()); ++p) {
    const PlacedPiece& placed = hanging.placed[p];
    if (hanging.parts[p] != BodyPart::kTorso || placed.up.y() < 0.9) continue;
    const Piece& piece = pattern->pieces[p];
    std::vector<Vec2> low_high{{1e9, 1e9}, {-1e9, -1e9}};
    for (const Vec2& v : piece.rest) low_high = {low_high[0].cwiseMin(v), low_high[1].cwiseMax(v)};
    const Vec2 middle = (low_high[0] + low_high[1]) / 2, size = low_high[1] - low_high[0];
    const double level = torso.axis().local(placed(middle)).z();
    const double half = Ring::girthOfTies(torso, level) / 2;
    if (size.y() > kTallestTied || size.x() / 2 < half + kLeastEnd) continue;
    Seam seam;
    const double bottom = low_high[0].y();
    seam.a = {p, knotted(piece, piece.rest, bottom, middle.x(), half, 1)};
    seam.b = {p, knotted(piece, piece.rest, bottom, middle.x(), half, -1)};
    const std::vector<int>&a = seam.a.vertices, &b = seam.b.vertices;
    bool alike = a.size() == b.size() && a.size() > 1;
    for (std::size_t k = 0; alike && k < a.size(); ++k)
      alike = std::abs(piece.rest[a[k]].x() + piece.rest[b[k]].x() - 2 * middle.x()) < kAlike;
    if (!alike) continue;
    seam.matched = false;
    pattern->seams.push_back(std::move(seam));
  }
}

double tiedAt(const Seam& seam, const std::vector<Vec2>& flat) {
  const std::vector<int>&a = seam.a.vertices, &b = seam.b.vertices;
  if (seam.a.piece != seam.b.piece || a.size() < 2 || seam.matched) return 0;
  const Vec2 along = flat[a[1]] - flat[a[0]], across = flat[a[0]] - flat[b[0]];
  const bool level =
      std::abs(along.y()) < std::abs(along.x()) && std::abs(across.y()) < kAlike + kLevel;
  return level ? std::abs(across.x()) / 2 : 0;
}

}  // namespace seamwise
