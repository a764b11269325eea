#include "mesh/coarser.h"

#include <gtest/gtest.h>

#include <functional>

#include "deform/prolong.h"
#include "support/meshed_samples.h"
#include "support/print_samples.h"

namespace seamwise {
namespace {

using testing::meshedPattern;

constexpr double kLongest = 2.1;  ///< cm
constexpr double kReach = 1.0;    ///< cm

struct Levels {
  Pattern fine;
  CoarserPattern coarser;
};

Levels levelsOf(bool symmetric, double edge_length) {
  Levels levels{meshedPattern(small::tee(1.5), symmetric, edge_length), {}};
  auto coarser = coarsened(levels.fine, kLongest);
  EXPECT_TRUE(coarser.has_value());
  if (coarser) levels.coarser = std::move(*coarser);
  return levels;
}

class Coarser : public ::testing::TestWithParam<std::tuple<bool, double>> {
 protected:
  Levels levels_ = levelsOf(std::get<0>(GetParam()), std::get<1>(GetParam()));
  const Pattern& fine_ = levels_.fine;
  const Pattern& coarse_ = levels_.coarser.pattern;

  /// Fitting plans of both patterns, as drafted.
  FittingPlan fine_plan_{fine_, {}, kReach}, coarse_plan_{coarse_, {}, kReach};
  WallpaperGroup group_ = testing::sampleGroup(*findGroup("pmm"));
  SeamFitting to_{fine_plan_, fine_, group_, {}}, from_{coarse_plan_, coarse_, group_, {}};

  /// Shapes of the finer pattern when every part of the coarser one moves by `move`.
  Shapes followed(const std::function<Vec2(const Vec2&)>& move) {
    std::vector<PartDeformation::State> states = from_.restStates();
    for (std::size_t c = 0; c < states.size(); ++c) {
      const Part& part = from_.parts().parts[c];
      for (std::size_t i = 0; i < part.rest.size(); ++i) {
        const Vec2 by = move(part.rest[i]);
        states[c].shape[i] += part.onAxis(static_cast<int>(i)) ? Vec2(0, by.y()) : by;
      }
    }
    from_.setStates(std::move(states));
    to_.setStates(prolonged(levels_.coarser, from_, to_));
    return to_.shapes();
  }
};

INSTANTIATE_TEST_SUITE_P(Tee, Coarser,
                         ::testing::Combine(::testing::Bool(), ::testing::Values(0.4, 1.0)),
                         [](const auto& test) {
                           return std::string(std::get<0>(test.param) ? "WithSymmetry"
                                                                      : "Without") +
                                  (std::get<1>(test.param) < 0.5 ? "Fine" : "Usual");
                         });

TEST_P(Coarser, HasFewerVerticesNoEdgeTooLongAndAllCorners) {
  for (std::size_t p = 0; p < fine_.pieces.size(); ++p) {
    const Piece &fine = fine_.pieces[p], &coarse = coarse_.pieces[p];
    EXPECT_LT(coarse.outline.size(), 0.8 * fine.outline.size());
    EXPECT_LT(coarse.triangles.size(), fine.triangles.size());
    for (std::size_t k = 0; k < coarse.outline.size(); ++k)
      EXPECT_LE((coarse.rest[(k + 1) % coarse.outline.size()] - coarse.rest[k]).norm(), kLongest);
    ASSERT_EQ(coarse.edge_start.size(), fine.edge_start.size());
    for (std::size_t e = 0; e < fine.edge_start.size(); ++e)
      EXPECT_EQ(coarse.rest[coarse.edge_start[e]], fine.rest[fine.edge_start[e]]);
  }
}

TEST_P(Coarser, KeepsSeamsPairedAndMirrorImagesMirrored) {
  ASSERT_EQ(coarse_.seams.size(), fine_.seams.size());
  for (std::size_t s = 0; s < coarse_.seams.size(); ++s) {
    const Seam &fine = fine_.seams[s], &coarse = coarse_.seams[s];
    ASSERT_EQ(coarse.a.vertices.size(), coarse.b.vertices.size());
    EXPECT_NEAR(coarse.length_ratio, fine.length_ratio, 0.01);
    EXPECT_EQ(coarse.twin, fine.twin);
    // vertices sewn together stay together in the finer pattern
    std::size_t k = 0;
    for (std::size_t i = 0; i < fine.a.vertices.size(); ++i) {
      const Vec2& a = fine_.pieces[fine.a.piece].rest[fine.a.vertices[i]];
      const Vec2& b = fine_.pieces[fine.b.piece].rest[fine.b.vertices[i]];
      if (k == coarse.a.vertices.size() ||
          coarse_.pieces[coarse.a.piece].rest[coarse.a.vertices[k]] != a)
        continue;
      EXPECT_EQ(coarse_.pieces[coarse.b.piece].rest[coarse.b.vertices[k]], b);
      ++k;
    }
    EXPECT_EQ(k, coarse.a.vertices.size());
  }
  ASSERT_EQ(coarse_.mirrors.size(), fine_.mirrors.size());
  EXPECT_LT(testing::shapeAsymmetry(coarse_, restShapes(coarse_)), 1e-6);
}

TEST_P(Coarser, ThePlacesOfTheFinerVerticesLieBesideThem) {
  for (std::size_t p = 0; p < fine_.pieces.size(); ++p) {
    const auto &fine = fine_.pieces[p].rest, &coarse = coarse_.pieces[p].rest;
    const auto& places = levels_.coarser.places[p];
    ASSERT_EQ(places.size(), fine_.pieces[p].outline.size());
    for (std::size_t v = 0; v < places.size(); ++v) {
      const auto& [from, to, share] = places[v];
      ASSERT_GE(share, 0);
      ASSERT_LT(share, 1);
      const Vec2 at = (1 - share) * coarse[from] + share * coarse[to];
      EXPECT_LT((at - fine[v]).norm(), 0.2) << "what is left out is no corner";
    }
  }
}

TEST_P(Coarser, AMoveOfAllIsFollowedByAll) {
  const bool symmetric = std::get<0>(GetParam());
  const Vec2 shift(symmetric ? 0 : 0.3, -0.2);  // along the axes of the halves
  const Shapes rest = to_.shapes(), moved = followed([&](const Vec2&) { return shift; });
  for (std::size_t p = 0; p < rest.size(); ++p)
    for (std::size_t v = 0; v < rest[p].size(); ++v)
      EXPECT_NEAR((moved[p][v] - rest[p][v]).norm(), shift.norm(), 1e-9);
}

TEST_P(Coarser, ASmoothMoveIsFollowedSmoothlyAndAsSymmetrically) {
  const auto swell = [](const Vec2& p) { return Vec2(0.02 * p.x(), 0.3 * std::sin(p.y() / 15)); };
  const Shapes rest = to_.shapes();
  const Shapes moved = followed(swell);
  EXPECT_LT(testing::shapeAsymmetry(fine_, moved), 1e-6);
  EXPECT_GT(testing::leastArea(fine_, moved), 0.8);
  for (const PartDeformation& deformation : to_.deformations()) {
    const Part& part = deformation.part();
    for (std::size_t i = 0; i < part.rest.size(); ++i) {
      if (part.reach[i] <= 0) continue;
      EXPECT_LT((deformation.shape()[i] - part.rest[i] - swell(part.rest[i])).norm(), 0.03);
    }
  }
}

TEST(CoarserPattern, IsNotMadeWhereThereIsLittleToLeaveOut) {
  EXPECT_FALSE(coarsened(meshedPattern(small::tee(1.5), true), 1.1).has_value());
}

}  // namespace
}  // namespace seamwise
