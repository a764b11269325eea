#include "io/result_json.h"
#include "support/level.h"
#include "support/solver_samples.h"

namespace seamwise {
namespace {

using testing::moveVertices;
using testing::panelsOf;
using testing::solved;
using testing::Task;
using testing::task;

/// Problems whose alignment search has the same result for any order of its random draws.
std::vector<Task> settledTasks() {
  std::vector<Task> tasks =
      testing::sampleOf<Task>(1, {task("gathered-skirt", "p1"), task("princess-dress", "p31m"),
                                  task("princess-dress", "pmm")});
  for (Task& t : tasks) t.options["maxChangeCm"] = 0;
  return tasks;
}

/// Three rectangles sewn side by side. A tube's girth is two repeats of the sample prints, so that
/// the mismatch can be zero, but only at a few angles. A strip is open and continues at any angle.
Task rectangles(const std::string& group, bool tube) {
  Task t;
  t.print = testing::samplePrint(group);
  t.garment = Json::parse(R"({"pattern": {"panels": {}, "stitches": []},
                              "properties": {"units_in_meter": 100}})");
  const std::array<double, 3> width{7, 8, 5};
  for (int k = 0; k < 3; ++k) {
    const double w = width[k];
    Json& panel = panelsOf(t.garment)["panel " + std::to_string(k)];
    panel["vertices"] = {{0, 0}, {w, 0}, {w, 20}, {0, 20}};
    for (int e = 0; e < 4; ++e) panel["edges"].push_back({{"endpoints", {e, (e + 1) % 4}}});
    auto side = [&](int p, int edge) {
      return Json{{"panel", "panel " + std::to_string(p)}, {"edge", edge}};
    };
    if (tube || k < 2)
      t.garment["pattern"]["stitches"].push_back({side(k, 1), side((k + 1) % 3, 3)});
  }
  return t;
}

constexpr double kZeroFit = 1e-6;  ///< cm2

bool hasObliqueLattice(const Task& t) {
  return findGroup(t.print["group"].get<std::string>())->lattice == LatticeType::kOblique;
}

struct Rewording {
  const char* name;
  std::function<void(Task&)> apply;
};

/// The same problem in other coordinates or another order; lengths don't change.
std::vector<Rewording> rewordings() {
  return {{"shifted",
           [](Task& t) {
             moveVertices(t.garment, [](int n, const Vec2& p) {
               return Vec2(p + Vec2(3.25 * n - 5, 7 - 2.5 * n));
             });
           }},
          {"turned",
           [](Task& t) {
             moveVertices(t.garment, [](int n, const Vec2& p) {
               return Vec2(rotation(0.7 * n - 1) * p + Vec2(3.25 * n - 5, 7 - 2.5 * n));
             });
           }},
          {"renamed", [](Task& t) { testing::renamePanels(t.garment); }},
          {"reordered", [](Task& t) { testing::reorder(t.garment); }},
          {"mirrored",
           [](Task& t) {
             testing::mirrorGarment(t.garment);
             // mirrors the print: of the sample lattices only the oblique one changes
             if (hasObliqueLattice(t)) t.print["w2"][0] = -t.print["w2"][0].get<double>();
           }},
          {"with another basis of the same lattice", [](Task& t) {
             if (!hasObliqueLattice(t)) return;
             for (int c : {0, 1})
               t.print["w2"][c] = t.print["w2"][c].get<double>() + t.print["w1"][c].get<double>();
           }}};
}

void expectPerfectHoweverWorded(const Task& plain) {
  EXPECT_LT(solved(plain).total_search, kZeroFit) << plain.print;
  for (const Rewording& r : rewordings()) {
    Task other = plain;
    r.apply(other);
    const Result result = solved(other);
    EXPECT_LT(result.total_search, kZeroFit) << plain.print << " " << r.name;
    EXPECT_LT(result.total.joined, 1e-3) << plain.print << " " << r.name;
    EXPECT_LT(result.max_moved_cm, 1e-3) << "there is nothing to deform";
    EXPECT_GT(result.total_random, 10) << "it could not fail";
  }
}

TEST(SolverInvariants, PerfectFitsStayPerfectHoweverTheProblemIsWorded) {
  for (const char* symmetry : {"auto", "none"}) {
    for (const char* group : testing::sampleOf<const char*>(2, {"pg", "p4m", "p1", "pmm"})) {
      Task t = rectangles(group, true);
      t.symmetry = symmetry;
      expectPerfectHoweverWorded(t);
    }
    for (const char* group : testing::sampleOf<const char*>(2, {"p2", "cmm", "pgg", "p3"})) {
      Task t = rectangles(group, false);
      t.symmetry = symmetry;
      expectPerfectHoweverWorded(t);
    }
  }
}

TEST(SolverInvariants, SearchesEndWithinFivePercentHoweverTheProblemIsWorded) {
  for (const Task& plain : settledTasks()) {
    const double fit = solved(plain).total_search;
    for (const Rewording& r : rewordings()) {
      Task other = plain;
      r.apply(other);
      EXPECT_NEAR(solved(other).total_search, fit, 0.05 * fit) << plain.print << " " << r.name;
    }
  }
}

TEST(SolverInvariants, RenamedPiecesGiveTheVerySameNumbers) {
  for (const Task& plain : testing::sampleOf<Task>(
           1, {task("tee", "pgg"), task("gathered-skirt", "p4m"), task("princess-dress", "p1")})) {
    Task renamed = plain;
    testing::renamePanels(renamed.garment);
    const Result a = solved(plain), b = solved(renamed);
    EXPECT_EQ(a.total_search, b.total_search);
    EXPECT_EQ(a.total.nearest, b.total.nearest);
    EXPECT_EQ(a.total.joined, b.total.joined);
    EXPECT_EQ(a.max_moved_cm, b.max_moved_cm);
    EXPECT_EQ(a.shapes, b.shapes);
  }
}

TEST(SolverInvariants, ShiftedPanelsFitAsBefore) {
  for (const Task& plain : settledTasks()) {
    Task shifted = plain;
    moveVertices(shifted.garment, [](int n, const Vec2& p) { return Vec2(p + Vec2(4.0 * n, 8)); });
    const double fit = solved(plain).total_search;
    // Rounding differs with the coordinates, so either of two tied answers may win in the search.
    EXPECT_NEAR(solved(shifted).total_search, fit, 1e-3 * fit);
  }
}

TEST(SolverInvariants, PinsMovedByALatticeVectorFitAsBefore) {
  for (const char* group : testing::sampleOf<const char*>(1, {"p4m", "p1"})) {
    for (const char* garment :
         testing::sampleOf<const char*>(1, {"tee", "gathered-skirt", "princess-dress"})) {
      Task t = task(garment, group);
      t.symmetry = "none";
      t.options["maxChangeCm"] = 0;
      const WallpaperGroup print = testing::problemOf(t).print.group;
      const std::string piece = panelsOf(t.garment).begin().key();
      auto pinnedAt = [&](const Vec2& p) {
        t.options["pins"][piece] = {{"angle", 0.4}, {"translation", {p.x(), p.y()}}};
        return solved(t);
      };
      const Vec2 pin(3, 4), vector = 2 * print.w1() - 3 * print.w2();
      const Result here = pinnedAt(pin), there = pinnedAt(pin + rotation(0.4) * vector);
      EXPECT_NEAR(here.total_search, there.total_search, 1e-6 * here.total_search);
      EXPECT_EQ(here.search[0].translation, pin);
      EXPECT_EQ(here.search[0].angle, 0.4);
    }
  }
}

TEST(SolverInvariants, TwiceTheGarmentOnTwiceThePrintHasFourTimesTheFit) {
  for (Task small : settledTasks()) {
    // Scaling a problem also scales its sampling, which stays below 1.05 cm at seams. Stiffness and
    // the least relevant distances are in cm, so only the search scales.
    small.options.update({{"edgeLengthCm", 0.5}, {"maxChangeCm", 0.5}});
    Task large = small;
    large.options.update({{"edgeLengthCm", 1}, {"maxChangeCm", 1}});
    moveVertices(large.garment, [](int, const Vec2& p) { return Vec2(2 * p); });
    large.print = testing::samplePrint(small.print["group"], 20);
    const Result a = solved(small), b = solved(large);
    EXPECT_NEAR(b.total_random, 4 * a.total_random, 1e-6 * b.total_random);
    EXPECT_NEAR(b.total_search, 4 * a.total_search, 0.05 * b.total_search);
  }
}

TEST(SolverInvariants, TheSameSeedGivesTheSameBytes) {
  for (Task t : testing::sampleOf<Task>(
           1, {task("tee", "p4m"), task("gathered-skirt", "p1"), task("princess-dress", "pgg")})) {
    t.seed = 7;
    EXPECT_EQ(writeResult(testing::solvedAnew(t)), writeResult(testing::solvedAnew(t)));
  }
}

TEST(SolverInvariants, WithoutSymmetryTheSearchIsNoWorse) {
  // the search starts from the symmetric answer, among others
  for (const char* group : testing::sampleOf<const char*>(2, {"p31m", "pgg", "pmm"})) {
    for (const char* garment :
         testing::sampleOf<const char*>(1, {"tee", "gathered-skirt", "princess-dress"})) {
      Task t = task(garment, group);
      t.options["maxChangeCm"] = 0;
      const double symmetric = solved(t).total_search;
      t.symmetry = "none";
      EXPECT_LE(solved(t).total_search, (1 + 1e-9) * symmetric) << garment << " " << group;
    }
  }
}

TEST(SolverInvariants, NoOutlineMovesFurtherThanAllowed) {
  for (const char* group : testing::sampleOf<const char*>(1, {"pmm", "p1", "p6m"})) {
    for (const char* garment :
         testing::sampleOf<const char*>(1, {"tee", "gathered-skirt", "princess-dress"})) {
      for (double allowed : {0.2, 1.0}) {
        Task t = task(garment, group);
        t.options["maxChangeCm"] = allowed;
        EXPECT_LE(solved(t).max_moved_cm, allowed) << garment << " " << group;
      }
    }
  }
}

}  // namespace
}  // namespace seamwise
