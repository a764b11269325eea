#pragma once
// Pieces for layouts, and independent checks of the layouts.
#include <memory>
#include <utility>
#include <vector>

#include "marker/marker.h"
#include "marker/marker_outlines.h"

namespace seamwise::testing {

/// Random pieces whose layout takes a moment.
inline MarkerProblem someProblem(WallpaperGroup group, int count, double width, unsigned seed) {
  MarkerProblem problem{std::move(group)};
  Random random(seed);
  for (int k = 0; k < count; ++k) {
    const double far = random.between(5, 9);
    const Polyline outline = k % 3 == 2 ? comb(random, 3) : star(random, 7, 3, far);
    // an alignment on grain, at a random place of the print
    const double turn = k % 2 == 0 ? 0 : kPi;
    problem.pieces.push_back(pieceOf("piece " + std::to_string(k + 1), outline,
                                     {turn, {random.between(0, 30), random.between(0, 30)}}));
    problem.pieces.back().garment = k % 2;
  }
  problem.width = width;
  problem.selvedge = 1;
  problem.gap = 0.2;
  problem.effort = 0.002;
  return problem;
}

inline std::unique_ptr<Marker> laid(const MarkerProblem& problem) {
  auto made = Marker::make(problem);
  EXPECT_TRUE(made.ok()) << made.error().message;
  if (!made.ok()) return nullptr;
  std::unique_ptr<Marker> marker = std::move(made).value();
  for (int steps = 0; marker->advance(1); ++steps) {
    if (steps < 100000) continue;
    ADD_FAILURE() << "the marker comes to no end";
    return nullptr;
  }
  EXPECT_FALSE(marker->error()) << marker->error()->message;
  return marker->error() ? nullptr : std::move(marker);
}

/// The error of a layout; empty when it succeeds.
inline std::string refusalOf(const MarkerProblem& problem) {
  auto made = Marker::make(problem);
  if (!made.ok()) return made.error().message;
  Marker& marker = *made.value();
  for (int steps = 0; steps < 100000 && marker.advance(1); ++steps) continue;
  return marker.error() ? marker.error()->message : "";
}

/// Returns whether a rotation or shift of the print, but no reflection, maps it to the fabric under
/// a piece.
inline bool showsPrint(const MarkerProblem& problem, const MarkerPiece& piece,
                       const RigidMotion& place, const Vec2& origin) {
  const RigidMotion to_print = piece.alignment.inverse();
  std::vector<Vec2> shifts = piece.shifts;
  shifts.push_back(Vec2::Zero());
  for (const Vec2& shift : shifts) {
    for (const Element& e : problem.group.elements()) {
      if (e.mirrored) continue;
      const auto off = [&](const Vec2& p) -> Vec2 {
        return place(p) - origin - e(to_print(p) + shift);
      };
      const Vec2 lattice = off({0, 0}) - problem.group.reduce(off({0, 0}));
      double worst = 0;
      for (const Vec2& p : {Vec2(0, 0), Vec2(60, 0), Vec2(13, 70)}) {
        worst = std::max(worst, (off(p) - lattice).norm());
        EXPECT_LE(problem.group.distance(place(p) - origin, to_print(p) + shift), worst + 1e-6);
      }
      if (worst <= 1e-6) return true;
    }
  }
  return false;
}

/// Expects places within the fabric, in register with the print and with the gap between them.
inline void expectValid(const MarkerProblem& problem, const Marker& marker) {
  ASSERT_EQ(marker.places().size(), problem.pieces.size());
  std::vector<Polyline> rings;
  double top = 0, bottom = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < problem.pieces.size(); ++k) {
    const MarkerPiece& piece = problem.pieces[k];
    const RigidMotion& place = marker.places()[k];
    EXPECT_FALSE(place.mirrored);
    if (!problem.ignores_print && !piece.pin) {
      EXPECT_TRUE(showsPrint(problem, piece, place, marker.origin())) << piece.name;
    }
    rings.push_back(moved(piece.outline, place));
    const auto [low, high] = boundsOf(rings.back());
    EXPECT_GT(low.x(), problem.selvedge - 1e-4) << piece.name;
    EXPECT_LT(high.x(), problem.width - problem.selvedge + 1e-4) << piece.name;
    EXPECT_GT(low.y(), -1e-4) << piece.name;
    bottom = std::min(bottom, low.y());
    top = std::max(top, high.y());
    for (const Polyline& flaw : problem.flaws) EXPECT_GE(separation(flaw, rings.back()), 0);
    for (std::size_t other = 0; other < k; ++other)
      EXPECT_TRUE(areApart(rings[other], rings[k], problem.gap, 0.008))
          << problem.pieces[other].name << ", " << piece.name;
  }
  if (!problem.start) {
    EXPECT_NEAR(bottom, 0, 1e-5);
  }
  if (!problem.whole_repeats) {
    EXPECT_NEAR(marker.length(), top, 1e-5);
  }
  EXPECT_LE(marker.bound(), marker.length() + 1e-9);
}

}  // namespace seamwise::testing
