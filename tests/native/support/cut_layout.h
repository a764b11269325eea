#pragma once
// Garments with a known perfect alignment: a printed plane cut into pieces.
#include "alignment/model/matching.h"
#include "support/print_samples.h"

namespace seamwise::testing {

inline constexpr int kSegments = 12;  ///< segments of every side of a cut piece

/// A curved cut from a to b, 12 segments.
inline std::vector<Vec2> cutLine(const Vec2& a, const Vec2& b, double bulge) {
  std::vector<Vec2> line;
  for (int k = 0; k <= kSegments; ++k) {
    const double t = static_cast<double>(k) / kSegments;
    line.push_back(a + t * (b - a) + bulge * std::sin(2.5 * t) * (1 - t) * perp(b - a));
  }
  return line;
}

/// Motions of the pieces of a layout after cutting.
enum class Scatter : std::uint8_t {
  kShifted,   ///< only shifted
  kTurned,    ///< moved by any rigid motion
  kMirrored,  ///< every other piece is cut from a mirrored place of the print, if there is one
};

/// columns x rows pieces of about 15 cm, each sewn to its neighbours, so that the mismatch can be
/// zero.
inline Pattern cutLayout(const WallpaperGroup& group, int columns, int rows, Scatter scatter,
                         unsigned seed) {
  Random random(seed);
  auto corner = [&](int c, int r) {
    Random own(1000 * seed + 50 * c + r);
    return Vec2(15 * c + own.between(-2, 2), 15 * r + own.between(-2, 2));
  };
  Pattern pattern;
  std::vector<bool> reversed;
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      const Vec2 p[4] = {corner(c, r), corner(c + 1, r), corner(c + 1, r + 1), corner(c, r + 1)};
      // neighbours share their cut, which always runs to the right and upwards
      auto bottom = cutLine(p[0], p[1], 0.1), right = cutLine(p[1], p[2], -0.15);
      auto top = cutLine(p[3], p[2], 0.1), left = cutLine(p[0], p[3], -0.15);
      std::reverse(top.begin(), top.end());
      std::reverse(left.begin(), left.end());
      Piece piece;
      piece.name = "piece " + std::to_string(pattern.pieces.size());
      for (const auto* side : {&bottom, &right, &top, &left})
        piece.rest.insert(piece.rest.end(), side->begin(), side->end() - 1);
      Element place;
      if (scatter == Scatter::kMirrored && (r + c) % 2 == 1) {
        for (const Element& e : group.elements())
          if (e.mirrored) place = e;
      }
      const Alignment table{scatter == Scatter::kShifted ? 0 : random.angle(), random.point()};
      for (Vec2& v : piece.rest) v = table.toPiece(place(v));
      if (place.mirrored) std::reverse(piece.rest.begin(), piece.rest.end());
      reversed.push_back(place.mirrored);
      for (int v = 0; v < 4 * kSegments; ++v) piece.outline.push_back(v);
      pattern.pieces.push_back(std::move(piece));
    }
  }
  // side 0 bottom, 1 right, 2 top, 3 left; counter-clockwise before any reversal
  auto sideOf = [&](int piece, int side, bool backwards) {
    SeamSide s{piece, {}};
    for (int k = 0; k <= kSegments; ++k) {
      const int v = (side * kSegments + (backwards ? kSegments - k : k)) % (4 * kSegments);
      s.vertices.push_back(reversed[piece] ? 4 * kSegments - 1 - v : v);
    }
    return s;
  };
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      const int here = r * columns + c;
      auto sew = [&](int side, int there) {
        Seam seam;
        seam.a = sideOf(here, side, false), seam.b = sideOf(there, (side + 2) % 4, true);
        pattern.seams.push_back(std::move(seam));
      };
      if (c + 1 < columns) sew(1, here + 1);
      if (r + 1 < rows) sew(2, here + columns);
    }
  }
  return pattern;
}

inline MatchProblem matchProblem(const Pattern& pattern, const WallpaperGroup& group,
                                 const std::vector<PieceRule>& rules = {},
                                 bool continuous_only = false) {
  MatchRules all{rules, {}, continuous_only};
  all.pieces.resize(pattern.pieces.size());
  return makeMatchProblem(pattern, restShapes(pattern), pattern.mirrors, all, group);
}

/// A random admissible alignment of every leader.
inline Alignments randomLeaders(const MatchProblem& problem, Random& random) {
  Alignments at;
  for (const Leader& leader : problem.leaders)
    at.push_back(leader.admissible.nearest(random.alignment(), leader.centre));
  return at;
}

}  // namespace seamwise::testing
