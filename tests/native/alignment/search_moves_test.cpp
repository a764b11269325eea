#include "alignment/search/search_moves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "alignment/search/candidates.h"
#include "pattern/discretise.h"
#include "support/cut_layout.h"
#include "support/small_garments.h"

namespace seamwise {
namespace {

using testing::matchProblem;
using testing::sampleGroup;

/// Three panels in a row, whose sewn sides curve differently, so that stretches of a seam match at
/// different angles.
Pattern sewnPanels() {
  Garment garment;
  for (const char* name : {"left", "middle", "right"})
    garment.panels.push_back(small::polygon(name, {{0, 0}, {20, 0}, {20, 30}, {0, 30}}));
  garment.panels[0].edges[1] = Curve::cubic({20, 0}, {28, 10}, {16, 20}, {20, 30});
  garment.panels[2].edges[3] = Curve::cubic({0, 30}, {7, 18}, {-5, 12}, {0, 0});
  small::sew(garment, "left", 1, "middle", 3);
  small::sew(garment, "middle", 1, "right", 3);
  return discretise(garment, {}, {}, 1).value();
}

TEST(SearchMoves, PlaceAPieceAtItsBestOrSecondBestCandidate) {
  const Pattern pattern = sewnPanels();
  const MatchProblem problem = matchProblem(pattern, sampleGroup(*findGroup("p4"), 0.2));
  const std::vector<Component> components = componentsOf(problem);
  ASSERT_EQ(components.size(), 1U);
  const SearchSamples samples(problem, 1);
  Alignments around(3);
  around[2] = {0.1, {1, 2}};
  int seconds = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SearchMoves moves(problem, samples, seed, 0);
    Layout layout = moves.layoutOf(around);
    std::vector<char> placed{1, 0, 1};
    moves.grow(components[0], layout, placed);

    Random random(seed);
    random.uniform();  // the choice of the piece
    std::vector<std::pair<double, double>> by_cost;
    for (const Alignment& choice :
         candidates(problem, 1, around, {1, 1, 1}, SearchTuning::kStretches, random)) {
      const Layout there = moves.layoutOf({around[0], choice, around[2]});
      by_cost.emplace_back(moves.costOf(components[0], there, 0), choice.angle);
    }
    ASSERT_GT(by_cost.size(), 2U);
    std::sort(by_cost.begin(), by_cost.end());
    const bool second = random.uniform() < SearchTuning::kSecondBest;
    EXPECT_EQ(layout.at[1].angle, by_cost[second ? 1 : 0].second) << "seed " << seed;
    seconds += second;
  }
  EXPECT_GT(seconds, 20) << "it could not fail";
}

}  // namespace
}  // namespace seamwise
