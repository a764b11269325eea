#include "methods/fitting_stage.h"

#include <gtest/gtest.h>

#include "support/cut_layout.h"
#include "support/meshed_samples.h"
#include "tuning/shaping.h"

namespace seamwise {
namespace {

using testing::matchProblem;
using testing::sampleGroup;

/// Two panels 30 cm high, sewn at their sides.
Pattern sewnPanels() {
  Garment garment;
  for (const char* name : {"left", "right"})
    garment.panels.push_back(small::polygon(name, {{0, 0}, {20, 0}, {20, 30}, {0, 30}}));
  small::sew(garment, "left", 1, "right", 3);
  return meshed(discretise(garment, {}, {}, 1).value(), 6).value();
}

/// Greatest movement of a vertex by the first steps of fitting, with the second panel turned. [cm]
double movedBySteps(double turn, double reach) {
  const Pattern pattern = sewnPanels();
  const MatchProblem match = matchProblem(pattern, sampleGroup(*findGroup("p1")));
  MatchRules rules;
  rules.pieces.resize(pattern.pieces.size());
  FittingPlans plans({}, reach);
  const Alignments start{{0, {20, 0}}, {turn, {0, 0}}};
  FittingStage stage(pattern, match, rules, {}, plans, {{start, true}}, reach);
  stage.advance();
  const Shapes rest = stage.fitting().shapes();
  stage.advance();
  double moved = 0;
  for (std::size_t p = 0; p < rest.size(); ++p)
    for (std::size_t v = 0; v < rest[p].size(); ++v)
      moved = std::max(moved, (stage.fitting().shapes()[p][v] - rest[p][v]).norm());
  return moved;
}

TEST(FittingStage, PullsOnlySeamsWithinReach) {
  const double reach = 0.5;
  EXPECT_GT(movedBySteps(0.05, reach), 5 * ShapingTuning::kLineReach);
  EXPECT_LT(movedBySteps(0.5, reach), 2 * ShapingTuning::kLineReach);
}

}  // namespace
}  // namespace seamwise
