#pragma once
// The shortest of all layouts by brute force, and by the program's search.
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <map>
#include <vector>

#include "marker/complete_search.h"
#include "marker/marker_outlines.h"

namespace seamwise::testing {

inline constexpr double kNowhere = std::numeric_limits<double>::infinity();

/// Finds the shortest of all layouts by trying all places of all pieces, one by one.
class Enumeration {
 public:
  /// @param longest   upper limit of the length. [cm]
  Enumeration(const MarkerProblem& problem, double longest)
      : problem_(problem), best_(longest), placed_(problem.pieces.size()) {
    const Vec2 origin(problem.phases[0], problem.start.value_or(0));
    for (const MarkerPiece& piece : problem.pieces) {
      places_.emplace_back();
      if (piece.pin) {
        add({moved(piece.outline, *piece.pin), isUp(piece.pin->linear(), piece)}, longest);
        continue;
      }
      const RigidMotion to_print = piece.alignment.inverse();
      const double turns = piece.turns == LayTurns::kHalf      ? 1
                           : piece.turns == LayTurns::kQuarter ? 2
                                                               : 12;
      for (const Element& e : problem.group.elements()) {
        if (e.mirrored || std::abs(std::sin(turns * e.angle)) > 1e-9) continue;
        Polyline ring;
        for (const Vec2& p : piece.outline) ring.emplace_back(e(to_print(p)) + origin);
        addPlaces({ring, isUp(e.A * to_print.linear(), piece)}, longest);
      }
    }
    search(0, kNowhere, -kNowhere);
  }
  /// Length of the shortest layout; `longest` where there is none.
  double length() const { return best_; }

 private:
  struct Place {
    Polyline ring;
    bool is_up;
  };

  static bool isUp(const Mat2& turn, const MarkerPiece& piece) {
    return (turn * piece.up).y() > -1e-6;
  }

  void addPlaces(const Place& place, double longest) {
    for (int i = -60; i <= 60; ++i)
      for (int j = -60; j <= 60; ++j)
        add({shifted(place.ring, i * problem_.group.w1() + j * problem_.group.w2()), place.is_up},
            longest);
  }

  void add(const Place& place, double longest) {
    const auto [low, high] = boundsOf(place.ring);
    if (low.x() < problem_.selvedge - 1e-6 || high.x() > problem_.width - problem_.selvedge + 1e-6)
      return;
    // if the start is not fixed, the first piece begins within the first two repeats of 8 cm
    const double least = problem_.start ? 0 : places_.size() == 1 ? 0 : -longest;
    const double most = problem_.start ? longest : places_.size() == 1 ? 16 : longest + 16;
    if (low.y() > least - 1e-6 && low.y() < most && !isOnFlaw(place.ring))
      places_.back().push_back(place);
  }

  bool isOnFlaw(const Polyline& ring) const {
    return std::any_of(problem_.flaws.begin(), problem_.flaws.end(), [&](const Polyline& flaw) {
      return !testing::areApart(flaw, ring, 0, kTouching);
    });
  }

  void search(std::size_t k, double bottom, double top) {
    if (k == places_.size()) {
      best_ = top - bottom;
      return;
    }
    for (std::size_t n = 0; n < places_[k].size(); ++n) {
      const auto [low, high] = boundsOf(places_[k][n].ring);
      const double from = problem_.start ? 0 : std::min(bottom, low.y());
      const double to = std::max(top, high.y());
      if (to - from >= best_ - 1e-6) continue;
      bool is_free = true;
      for (std::size_t other = 0; other < k && is_free; ++other) is_free = areFree(other, k, n);
      placed_[k] = n;
      if (is_free) search(k + 1, from, to);
    }
  }

  bool areFree(std::size_t other, std::size_t k, std::size_t n) {
    const auto [at, is_new] = free_.try_emplace({other, placed_[other], k, n}, false);
    if (is_new) {
      const Place &a = places_[other][placed_[other]], &b = places_[k][n];
      const auto middle = [](const auto& bounds) -> Vec2 {
        return (bounds.first + bounds.second) / 2;
      };
      const double apart = (middle(boundsOf(a.ring)) - middle(boundsOf(b.ring))).norm();
      const double gap = problem_.gap + problem_.repeat_tolerance * apart;
      const bool is_turned = problem_.nap == Nap::kGarment && a.is_up != b.is_up &&
                             problem_.pieces[other].garment == problem_.pieces[k].garment;
      at->second = !is_turned && testing::areApart(a.ring, b.ring, gap, kTouching);
    }
    return at->second;
  }

  const MarkerProblem& problem_;
  double best_;
  std::vector<std::vector<Place>> places_;  ///< per piece
  std::vector<std::size_t> placed_;
  std::map<std::array<std::size_t, 4>, bool> free_;
};

/// Length that the complete search finds, in steps to ever shorter layouts. [cm]
inline double completely(const MarkerProblem& problem, double longest) {
  PiecesOnBoard pieces(problem, false);
  while (pieces.makeTable()) continue;
  LayFabric fabric;
  fabric.left = problem.selvedge;
  fabric.right = problem.width - problem.selvedge;
  fabric.is_by_garment = problem.nap == Nap::kGarment;
  fabric.is_fixed = problem.start.has_value();
  fabric.origin = {problem.phases[0], problem.start.value_or(0)};
  double best = kNowhere;
  for (double target = longest; target > 0; target = best - 1e-4) {
    CompleteSearch search(pieces, fabric, target);
    EXPECT_TRUE(search.canProve());
    if (!search.canProve()) return kNowhere;
    while (search.step(1e4)) continue;
    if (!search.found()) return best;
    EXPECT_LE(search.found()->length(), target + 1e-5);
    best = search.found()->length();
  }
  return best;
}

}  // namespace seamwise::testing
