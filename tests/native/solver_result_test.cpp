#include <limits>

#include "geometry/polygon.h"
#include "meshed_samples.h"
#include "print_samples.h"
#include "solver_samples.h"

namespace seamwise {
namespace {

using testing::solved;
using testing::Task;
using testing::task;

/// An independent reckoning of the figures: elements straight from the table of groups, lattice
/// shifts by trying them all around the nearest.
class Reckoning {
 public:
  explicit Reckoning(const Result& r) : r_(r) {
    basis_ << r.w1, r.w2;
    for (const LatticeElement& e : cosets(*findGroup(r.group))) {
      const Mat2 m = (Mat2() << e.m[0], e.m[1], e.m[2], e.m[3]).finished();
      linear_.push_back(basis_ * m * inverse());
      shift_.push_back(basis_ * Vec2(e.a[0], e.a[1]));
    }
  }

  double fit(const Shapes& shapes, const std::vector<Alignment>& at, bool strict = false) const {
    double total = 0;
    eachSeam([&](const Seam& s) {
      for (std::size_t i = 0; i + 1 < s.a.vertices.size(); ++i) {
        const Edge a = edge(s.a, i, shapes, at), b = edge(s.b, i, shapes, at);
        std::vector<double> turns, distances;
        for (std::size_t k = 0; k < linear_.size(); ++k) {
          turns.push_back(std::acos(std::clamp(
              a.direction.normalized().dot((linear_[k] * b.direction).normalized()), -1.0, 1.0)));
          distances.push_back(shortest(a.middle - linear_[k] * b.middle - shift_[k]));
        }
        const double limit = *std::min_element(turns.begin(), turns.end()) + 0.1;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < turns.size(); ++k)
          if (!strict || turns[k] <= limit) least = std::min(least, distances[k]);
        total += (a.direction.norm() + b.direction.norm()) / 2 * least;
      }
    });
    return total;
  }

  double seamFit(const Shapes& shapes, const std::vector<Alignment>& at) const {
    double total = 0;
    eachSeam([&](const Seam& s) {
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < linear_.size(); ++k) {
        const std::size_t n = s.a.vertices.size() - 1;
        const Edge a0 = edge(s.a, n / 2, shapes, at), b0 = edge(s.b, n / 2, shapes, at);
        const Vec2 cell = inverse() * (a0.middle - linear_[k] * b0.middle - shift_[k]);
        for (int u = -3; u <= 3; ++u) {
          for (int v = -3; v <= 3; ++v) {
            const Vec2 shift = basis_ * Vec2(std::round(cell.x()) + u, std::round(cell.y()) + v);
            double cost = 0;
            for (std::size_t i = 0; i < n; ++i) {
              const Edge a = edge(s.a, i, shapes, at), b = edge(s.b, i, shapes, at);
              cost += (a.direction.norm() + b.direction.norm()) / 2 *
                      (a.middle - linear_[k] * b.middle - shift_[k] - shift).norm();
            }
            least = std::min(least, cost);
          }
        }
      }
      total += least;
    });
    return total;
  }

 private:
  struct Edge {
    Vec2 middle, direction;
  };

  Mat2 inverse() const {
    const double det = cross(basis_.col(0), basis_.col(1));
    return (Mat2() << basis_(1, 1), -basis_(0, 1), -basis_(1, 0), basis_(0, 0)).finished() / det;
  }
  double shortest(const Vec2& v) const {
    const Vec2 c = inverse() * v;
    double least = std::numeric_limits<double>::infinity();
    for (int i = -2; i <= 2; ++i)
      for (int j = -2; j <= 2; ++j)
        least = std::min(least,
                         (v - basis_ * Vec2(std::round(c.x()) + i, std::round(c.y()) + j)).norm());
    return least;
  }
  void eachSeam(const std::function<void(const Seam&)>& visit) const {
    for (const Seam& s : r_.pattern.seams)
      if (s.matched && !s.twin) visit(s);
  }
  Edge edge(const SeamSide& s, std::size_t i, const Shapes& shapes,
            const std::vector<Alignment>& at) const {
    const Vec2 from = at[s.piece].toPrint(shapes[s.piece][s.vertices[i]]);
    const Vec2 to = at[s.piece].toPrint(shapes[s.piece][s.vertices[i + 1]]);
    return {(from + to) / 2, to - from};
  }

  const Result& r_;
  Mat2 basis_;
  std::vector<Mat2> linear_;
  std::vector<Vec2> shift_;
};

/// Greatest movement of an outline vertex as it lies. [cm]
double movedAsItLies(const Result& r) {
  double worst = 0;
  for (std::size_t p = 0; p < r.shapes.size(); ++p)
    for (int v : r.pattern.pieces[p].outline)
      worst = std::max(worst, (r.shapes[p][v] - r.pattern.pieces[p].rest[v]).norm());
  return worst;
}

std::vector<Task> tasks() {
  std::vector<Task> all;
  for (const char* garment : {"gathered-skirt", "tee", "princess-dress"})
    for (const char* group : {"p1", "pmm", "p31m", "pgg"}) all.push_back(task(garment, group));
  return all;
}

TEST(Metrics, SayWhatTheGeometrySays) {
  for (const Task& t : tasks()) {
    const Result r = solved(t);
    const Reckoning own(r);
    const Shapes rest = restShapes(r.pattern);
    auto expectClose = [&](double stated, double found) {
      EXPECT_NEAR(stated, found, 1e-9 * (1 + found)) << t.print;
    };
    expectClose(r.fit.any, own.fit(r.shapes, r.alignment));
    expectClose(r.fit.strict, own.fit(r.shapes, r.alignment, true));
    expectClose(r.fit.seam, own.seamFit(r.shapes, r.alignment));
    expectClose(r.fit_search, own.fit(rest, r.search));
    expectClose(r.fit_aligned, own.fit(rest, r.alignment));
    EXPECT_LE(r.max_moved_cm, movedAsItLies(r) + 1e-12);
    EXPECT_LE(r.fit.any, r.fit.strict * (1 + 1e-9));
    EXPECT_LE(r.fit.any, r.fit.seam * (1 + 1e-9));
    EXPECT_LT(r.fit_search, r.fit_random);
  }
}

TEST(Metrics, FitOfRandomAlignmentsIsTheirMean) {
  const Result r = solved(task("tee", "pmm"));
  const Reckoning own(r);
  testing::Random random(1);
  double total = 0;
  constexpr int kDraws = 60;
  for (int k = 0; k < kDraws; ++k) {
    std::vector<Alignment> at(r.pattern.pieces.size());
    for (Alignment& a : at) a = random.alignment();
    total += own.fit(restShapes(r.pattern), at) / kDraws;
  }
  EXPECT_NEAR(r.fit_random, total, 0.1 * total);
}

TEST(Metrics, MismatchOfEverySeamIsThatOfItsJoin) {
  const Result r = solved(task("tee", "p4m"));
  ASSERT_EQ(r.joins.size(), r.pattern.seams.size());
  double total = 0;
  for (std::size_t s = 0; s < r.joins.size(); ++s) {
    const Seam& seam = r.pattern.seams[s];
    ASSERT_EQ(r.mismatch[s].size(), seam.a.vertices.size() - 1);
    const SeamMidpoints m = seamMidpoints(seam, r.shapes, r.alignment);
    for (std::size_t i = 0; i < m.x.size(); ++i)
      if (seam.matched && !seam.twin) total += m.length[i] * r.mismatch[s][i];
  }
  EXPECT_NEAR(total, r.fit.seam, 1e-9 * total);
}

TEST(BestMethod, KeepsSymmetrySewabilityAndTheGarmentsLines) {
  for (const Task& t : tasks()) {
    const Result r = solved(t);
    const WallpaperGroup group = testing::problemOf(t).print.group;
    for (const Mirror& m : r.pattern.mirrors) {
      const Alignment &first = r.alignment[m.pieces[0]], &second = r.alignment[m.pieces[1]];
      EXPECT_LT(testing::asymmetry(group, first, second, m.map), 1e-6);
    }
    EXPECT_LT(testing::shapeAsymmetry(r.pattern, r.shapes), 1e-6);
    EXPECT_LT(testing::seamError(r.pattern, r.shapes), 0.01);
    EXPECT_GT(testing::leastArea(r.pattern, r.shapes), 0.3);
    for (std::size_t p = 0; p < r.shapes.size(); ++p) {
      const auto& outline = r.pattern.pieces[p].outline;
      const auto& rest = r.pattern.pieces[p].rest;
      Polyline now;
      for (std::size_t k = 0; k < outline.size(); ++k) {
        const int u = outline[k], v = outline[(k + 1) % outline.size()];
        now.push_back(r.shapes[p][u]);
        EXPECT_NEAR((r.shapes[p][v] - r.shapes[p][u]).norm() / (rest[v] - rest[u]).norm(), 1, 0.15);
      }
      EXPECT_FALSE(findCrossing(now).has_value()) << r.pattern.pieces[p].name;
    }
  }
}

TEST(BestMethod, IsStifferWithALargerAlphaAndAveragesSeamShapesWhenAsked) {
  const Task plain = task("tee", "pgg");
  Task soft = plain, stiff = plain, averaged = plain;
  soft.options["alpha"] = 0.1, stiff.options["alpha"] = 100;
  averaged.options["averageSeamShapes"] = true;
  const Result softly = solved(soft), stiffly = solved(stiff), average = solved(averaged);
  EXPECT_LT(softly.fit.any, stiffly.fit.any);
  EXPECT_NE(average.shapes, solved(plain).shapes);
  for (const Result* r : {&softly, &stiffly, &average}) {
    EXPECT_LT(r->fit.any, r->fit_aligned);
    EXPECT_LT(testing::seamError(r->pattern, r->shapes), 0.01);
    EXPECT_LE(r->max_moved_cm, 1);
  }
}

TEST(OtherMethods, EndAndKeepTheGreatestChange) {
  for (Method method : {Method::kPaper, Method::kWs19}) {
    Task t = task("gathered-skirt", "pmm");
    t.method = method;
    const Result r = solved(t);
    EXPECT_EQ(r.method, method);
    EXPECT_GT(r.iterations, 0);
    EXPECT_EQ(r.pattern.mirrors.empty(), method == Method::kWs19);
    EXPECT_LT(testing::shapeAsymmetry(r.pattern, r.shapes), 1e-3);
    EXPECT_LT(testing::seamError(r.pattern, r.shapes), 0.01);
    EXPECT_GT(testing::leastArea(r.pattern, r.shapes), 0);
    EXPECT_LE(r.max_moved_cm, 1);
    EXPECT_NEAR(r.fit.any, Reckoning(r).fit(r.shapes, r.alignment), 1e-9 * (1 + r.fit.any));
  }
}

TEST(Solver, ReportsPhasesInOrderProgressThatNeverFallsAndAnAlignmentThroughout) {
  for (Method method : {Method::kBest, Method::kPaper}) {
    Task t = task("gathered-skirt", "pmm");
    t.method = method;
    t.options["alpha"] = 4;  // of the other methods: they need not look for one
    Outcome<Solver> made = Solver::make(testing::problemOf(t));
    ASSERT_TRUE(made.ok());
    Solver& solver = made.value();
    double fraction = 0;
    Phase phase = Phase::kAlignment;
    bool more = true;
    while (more) {
      more = solver.advance(1);
      EXPECT_GE(solver.fraction(), fraction);
      EXPECT_GE(solver.phase(), phase);
      EXPECT_EQ(solver.partial().size(), solver.pattern().pieces.size());
      fraction = solver.fraction(), phase = solver.phase();
    }
    EXPECT_EQ(fraction, 1);
    EXPECT_EQ(phase, Phase::kDone);
    EXPECT_FALSE(solver.advance(1));
    EXPECT_TRUE(solver.finish().ok());
  }
}

TEST(SearchBound, SaysHowMuchBetterAnAlignmentCouldBe) {
  const auto boundOf = [](Task t, double proof) {
    t.options["proof"] = proof;
    return solved(t).search_bound;
  };
  EXPECT_EQ(boundOf(task("apron", "pmm"), 0), 1);  // meets everywhere: nothing is better
  const Task hard = task("gathered-skirt", "cm");
  const double none = boundOf(hard, 0), little = boundOf(hard, 0.005), much = boundOf(hard, 0.3);
  EXPECT_EQ(none, 0);
  EXPECT_GT(little, 0);
  EXPECT_LT(little, 1);
  EXPECT_EQ(much, 1);
  Task paper = hard;
  paper.method = Method::kPaper;
  EXPECT_EQ(solved(paper).search_bound, 0);
}

}  // namespace
}  // namespace seamwise
