#include "methods/seam_rules.h"

#include "pattern/discretise.h"
#include "support/garment_texts.h"
#include "support/level.h"
#include "support/solver_samples.h"

namespace seamwise {
namespace {

using testing::problemOf;
using testing::solved;
using testing::Task;
using testing::task;

Task onGrain(const std::string& garment, const std::string& group) {
  Task t = task(garment, group);
  t.options["grain"] = {{"default", "on"}};
  return t;
}

/// Greatest distance of a panel edge's vertices from the line from its first to its last. [cm]
double offLine(const Result& result, int piece, int edge) {
  const Piece& p = result.pattern.pieces[piece];
  const int n = static_cast<int>(p.outline.size());
  const int from = p.edge_start[edge];
  const int to = edge + 1 < static_cast<int>(p.edge_start.size()) ? p.edge_start[edge + 1] : n;
  const Vec2 along = (p.rest[to % n] - p.rest[from]).normalized();
  double off = 0;
  for (int k = from; k <= to; ++k)
    off = std::max(off, std::abs(cross(along, result.shapes[piece][k % n] - p.rest[from])));
  return off;
}

Pattern twoRectanglesPattern() {
  const Garment garment = testing::mustRead(testing::twoRectangles()).garment;
  return discretise(garment, {}, {}, 1).value();
}

TEST(Verdict, LeavesAloneWhatIsNotBentAndNoWorse) {
  EXPECT_EQ(verdictOn({1.2, 1.2, 1.2}, 0, 0), Verdict::kKept);
  EXPECT_EQ(verdictOn({0, 0.8, 0.09}, 0.9, 0), Verdict::kKept);  // matches nevertheless
  EXPECT_EQ(verdictOn({1.2, 1.2, 0.4}, 0.9, 0), Verdict::kKept);
}

TEST(Verdict, FindsWhatIsBentInVain) {
  EXPECT_EQ(verdictOn({0.8, 0.8, 0.65}, 0.2, 0), Verdict::kInVain);  // gains less than a quarter
  EXPECT_EQ(verdictOn({3.0, 3.0, 2.0}, 0.2, 0),
            Verdict::kInVain);  // mismatched, gains under a half
  EXPECT_EQ(verdictOn({0.8, 0.8, 0.65}, 0.05, 0), Verdict::kKept);  // movement too small to see
}

TEST(Verdict, FindsWhatIsWorseThanByPlacingAlone) {
  EXPECT_EQ(verdictOn({0, 1, 0.3}, 0.9, 0), Verdict::kWorse);
  EXPECT_EQ(verdictOn({0.5, 0.5, 0.55}, 0, 0), Verdict::kWorse);
  EXPECT_EQ(verdictOn({0.5, 0.5, 0.52}, 0, 0), Verdict::kKept);
}

TEST(Verdict, LeavesALostSeamUnprotectedIfSeamsCountByVisibility) {
  EXPECT_EQ(verdictOn({0.6, 0.6, 0.9}, 0, 2), Verdict::kKept);
  EXPECT_EQ(verdictOn({0.4, 0.4, 0.45}, 0, 2), Verdict::kWorse);
  EXPECT_EQ(verdictOn({0.1, 0.1, 0.25}, 0, 2), Verdict::kWorse);
  EXPECT_EQ(verdictOn({0.1, 0.1, 0.25}, 0, 0.5), Verdict::kKept);  // hardly seen, within 3 mm
  EXPECT_EQ(verdictOn({0.8, 0.8, 0.65}, 0.2, 2), Verdict::kKept);
  EXPECT_EQ(verdictOn({0.8, 0.8, 0.7}, 0.2, 2), Verdict::kInVain);
}

TEST(Unmatched, GrowsSmoothlyWithTheShareThatIsOff) {
  EXPECT_EQ(unmatched(0), 0);
  EXPECT_NEAR(unmatched(0.1), 0.5, 1e-12);
  EXPECT_EQ(unmatched(0.2), 1);
  EXPECT_EQ(unmatched(1), 1);
}

TEST(Bend, LeavesOutRigidMotions) {
  const Pattern pattern = twoRectanglesPattern();
  Shapes shapes = restShapes(pattern);
  const RigidMotion motion{0.3, Vec2(1, -2), false};
  for (Vec2& p : shapes[0]) p = motion(p);
  EXPECT_LT(seamBend(pattern.seams[0], pattern, shapes), 1e-12);
  EXPECT_GT(seamMovement(pattern.seams[0], pattern, shapes), 1);
  const int middle = pattern.seams[0].a.vertices[3];
  shapes[0][middle] += Vec2(0.5, 0);
  EXPECT_GT(seamBend(pattern.seams[0], pattern, shapes), 0.3);
}

TEST(Reach, IsWhatBothSidesMayMoveTogether) {
  EXPECT_TRUE(isWithinReach({2, 2, 2}, 1));
  EXPECT_FALSE(isWithinReach({4, 4, 4}, 1));
}

TEST(SolvedSeams, AreNeverWorseThanByPlacingAloneNorBentInVain) {
  for (const char* garment :
       testing::sampleOf<const char*>(2, {"tee", "gathered-skirt", "apron", "raglan", "trousers"}))
    for (const char* group : {"pmm", "p1"}) {
      const Result result = solved(onGrain(garment, group));
      const Shapes rest = restShapes(result.pattern);
      const WallpaperGroup print = WallpaperGroup::make(result.group, result.w1, result.w2).value();
      for (std::size_t s = 0; s < result.figures.size(); ++s) {
        const Seam& seam = result.pattern.seams[s];
        if (!counts(seam)) continue;
        const SeamFigures& of = result.figures[s];
        const double aligned = localMismatch(print, seam, rest, result.alignment);
        EXPECT_TRUE(of.final <= of.placed + 0.0301 || of.final < 0.1)
            << garment << ' ' << group << " seam " << s;
        if (of.shaped) {
          EXPECT_LE(of.final, 0.75 * aligned) << garment << ' ' << group << " seam " << s;
        }
      }
      EXPECT_LE(result.local.final, result.local.drafted + 1e-9) << garment << ' ' << group;
      EXPECT_LE(result.local.final, result.local.worst + 1e-12);
    }
}

TEST(SolvedSeams, SayWhyTheyStayOff) {
  const Result result = solved(onGrain("gathered-skirt", "pmm"));
  int gathers = 0;
  for (const SeamFigures& of : result.figures) {
    EXPECT_EQ(of.reason == SeamReason::kNone, !(of.final > kSeenMismatch));
    gathers += of.reason == SeamReason::kGather;
  }
  EXPECT_GT(gathers, 0);
}

TEST(OpenEdges, KeepTheirLineUnlessTheyAreFree) {
  const Result kept = solved(onGrain("tee", "pmm"));
  const Piece& front = kept.pattern.pieces[0];
  double most = 0;
  for (int edge = 0; edge < static_cast<int>(front.edge_start.size()); ++edge) {
    bool sewn = false;
    for (const Stitch& stitch : problemOf(onGrain("tee", "pmm")).garment.stitches)
      for (const EdgeRef& ref : {stitch.a, stitch.b}) sewn = sewn || ref == EdgeRef{0, edge};
    const Panel panel = problemOf(onGrain("tee", "pmm")).garment.panels[0];
    const Curve& curve = panel.edges[edge];
    const bool straight = (curve.at(0.5) - (curve.start() + curve.end()) / 2).norm() < 1e-9;
    if (!sewn && straight) most = std::max(most, offLine(kept, 0, edge));
  }
  EXPECT_LT(most, 0.06);
}

TEST(LockedEdges, StayAsDrafted) {
  Task t = onGrain("princess-dress", "pmm");
  const Result free = solved(t);
  const std::string name = free.pattern.pieces[0].name;
  t.options["locked"] = {{name, true}};
  const Result locked = solved(t);
  const Piece& piece = locked.pattern.pieces[0];
  double moved = 0;
  for (const int v : piece.outline)
    moved = std::max(moved, (locked.shapes[0][v] - piece.rest[v]).norm());
  EXPECT_LT(moved, 0.02);
}

TEST(GreatestChange, MayBeNothing) {
  Task t = onGrain("tee", "pmm");
  t.options["maxChangeCm"] = 0;
  const Result result = solved(t);
  EXPECT_LT(result.max_moved_cm, 1e-9);
  EXPECT_NEAR(result.local.final, result.local.placed, 1e-12);
  EXPECT_FALSE(result.pattern.mirrors.empty());
}

TEST(Effort, NeverEndsWorse) {
  Task t = onGrain("asymmetric-dress", "pgg");
  const Result once = solved(t);
  t.options["effort"] = 2;
  EXPECT_LE(solved(t).total.nearest, once.total.nearest);
}

TEST(FreedomFromSymmetry, NeverEndsWorse) {
  const auto cases = testing::sampleOf<std::pair<const char*, const char*>>(
      1, {{"raglan", "pgg"}, {"trousers", "pmm"}, {"shirt", "p31m"}, {"six-gore-skirt", "p31m"}});
  int its_placing = 0;
  for (const auto& [garment, group] : cases) {
    Task t = onGrain(garment, group);
    const Result symmetric = solved(t);
    t.symmetry = "none";
    const Result free = solved(t);
    ASSERT_EQ(free.pattern.pieces.size(), symmetric.pattern.pieces.size());
    for (std::size_t p = 0; p < free.pattern.pieces.size(); ++p)
      EXPECT_EQ(free.pattern.pieces[p].rest, symmetric.pattern.pieces[p].rest) << garment;
    EXPECT_LE(free.total.nearest, symmetric.total.nearest * (1 + 1e-9)) << garment << ' ' << group;
    EXPECT_LE(free.search_bound, 1);
    its_placing += free.search == symmetric.search;
  }
  EXPECT_GT(its_placing, 0) << "which stands with the shapes";
}

TEST(FreedomFromSymmetry, TakesSymmetryThatWasOnlyAskedForInPart) {
  Task t = onGrain("raglan", "pgg");
  const Result whole = solved(t);
  ASSERT_GT(whole.pattern.mirrors.size(), 1u);
  const Mirror& one = whole.pattern.mirrors[0];
  const auto name = [&](int side) { return whole.pattern.pieces[one.pieces[side]].name; };
  Json symmetry = {{"kind", "pair"}, {"pieces", {name(0), name(1)}}};
  if (one.single()) symmetry = {{"kind", "piece"}, {"piece", name(0)}};
  t.symmetry = Json{{"symmetries", {symmetry}}}.dump();
  const Result part = solved(t);
  EXPECT_EQ(part.pattern.mirrors.size(), 1u);
  EXPECT_LE(part.total.nearest, whole.total.nearest * (1 + 1e-9));
}

}  // namespace
}  // namespace seamwise
