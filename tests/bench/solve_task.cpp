// Results, times and memory of a solve.
#include <algorithm>
#include <cmath>

#include "alignment/model/matching.h"
#include "bench.h"
#include "methods/metrics.h"
#include "problem/prepare.h"

namespace seamwise::bench {
namespace {

/// Mean of TotalMismatch::joined over random alignments. It corresponds to the joined total as
/// randomMismatch() does to the total of the nearest elements. [cm2]
double seamFitRandom(const WallpaperGroup& group, const Pattern& pattern) {
  const Shapes rest = restShapes(pattern);
  const auto draws = randomAlignments(group, pattern.pieces.size());
  double total = 0;
  for (const auto& at : draws)
    for (const Seam& seam : pattern.seams)
      if (seam.matched && !seam.twin) total += bestJoin(group, seam, rest, at).cost;
  return total / static_cast<double>(draws.size());
}

/// Pieces whose alignment is an independent variable.
int freePieces(const Problem& problem, const Pattern& pattern) {
  const MatchProblem match = makeMatchProblem(pattern, restShapes(pattern), pattern.mirrors,
                                              rulesOf(problem), problem.print.group);
  return static_cast<int>(std::count_if(
      match.leaders.begin(), match.leaders.end(),
      [](const Leader& leader) { return !leader.seams.empty() && !leader.admissible.isPinned(); }));
}

}  // namespace

Timed timedSolve(const std::function<Problem()>& make, const SolveMemo& memo) {
  Timed timed;
  SolveMemo before_this = memo;
  std::vector<std::pair<double, double>> reports;  // time, fraction
  const Watch all;
  Solver solver = required(Solver::make(make(), &before_this));
  timed.prepare = all.milliseconds();
  Alignments first;
  int attempt = solver.attempt();
  for (bool more = true; more;) {
    const Phase phase = solver.phase();
    const Watch watch;
    more = solver.advance(1);
    const double spent = watch.milliseconds();
    if (solver.attempt() != attempt) {
      timed.earlier += std::exchange(timed.deformation, 0);
      attempt = solver.attempt();
    }
    (phase == Phase::kAlignment ? timed.alignment : timed.deformation) += spent;
    if (reports.empty()) first = solver.partial(), timed.first = all.milliseconds();
    reports.emplace_back(all.milliseconds(), solver.fraction());
  }
  const Watch measuring;
  timed.result = required(solver.finish());
  timed.measuring = measuring.milliseconds();
  const double end = all.milliseconds();
  double before = 0;
  for (const auto& [time, fraction] : reports) {
    timed.monotone &= fraction >= before;
    before = fraction;
    timed.astray = std::max(timed.astray, std::abs(fraction - time / end));
  }
  const Problem problem = make();
  timed.first_fit =
      totalMismatch(problem.print.group, solver.pattern(), restShapes(solver.pattern()), first);
  return timed;
}

Timed quickest(const Json& task, const std::function<Problem()>& make, const SolveMemo& memo) {
  const int times = task.value("times", 1);
  const double long_enough = task.value("atLeast", 0.0);
  const Watch watch;
  const PeakMemory memory;
  Timed best = timedSolve(make, memo);
  const double cold = best.first, peak = memory.bytes();
  for (int k = 1; k < times || watch.milliseconds() < long_enough; ++k) {
    Timed other = timedSolve(make, memo);
    if (other.total() < best.total()) best = std::move(other);
  }
  best.cold_first = cold, best.peak_memory = peak;
  return best;
}

Json solveTask(const Json& task) {
  const Timed timed = quickest(task, [&] { return problemOf(task); });
  const Result& r = timed.result;
  const Problem problem = problemOf(task);
  return {{"pieces", r.pattern.pieces.size()},
          {"freePieces", freePieces(problem, r.pattern)},
          {"symmetries", r.pattern.mirrors.size()},
          {"triangles", trianglesOf(r.pattern)},
          {"fitRandom", r.total_random},
          {"fitSeamRandom", seamFitRandom(problem.print.group, r.pattern)},
          {"fitDrafted", r.total_drafted},
          {"fitSearch", r.total_search},
          {"fitAligned", r.total_aligned},
          {"fit", r.total.nearest},
          {"fitSeam", r.total.joined},
          {"off", r.local.off},
          {"p90", r.local.p90},
          {"iterations", r.iterations},
          {"factorisations", r.factorisations},
          {"milliseconds",
           {{"prepare", timed.prepare},
            {"alignment", timed.alignment},
            {"deformation", timed.deformation},
            {"measuring", timed.measuring},
            {"total", timed.total()},
            {"earlierAttempts", timed.earlier}}},
          {"firstAlignment", timed.cold_first},
          {"progress", {{"monotone", timed.monotone}, {"astray", timed.astray}}},
          {"peakMemory", timed.peak_memory}};
}

/// Finds the edge length at which the mesh has about as many triangles as the task requires, or the
/// fewest possible.
Json meshTask(const Json& task) {
  const double wanted = task.at("triangles");
  constexpr double kLongest = 1.05;  // cm; seams are never sampled more coarsely
  double length = kLongest;
  int triangles = 0;
  for (int round = 0; round < 8; ++round) {
    Problem problem = problemOf(task);
    problem.options.edge_length_cm = length;
    triangles = trianglesOf(required(prepared(problem)).pattern);
    const bool coarsest = length == kLongest && triangles > wanted;
    if (coarsest || std::abs(triangles / wanted - 1) < 0.02) break;
    length = std::min(kLongest, length * std::pow(triangles / wanted, 0.8));
  }
  return {{"edgeLength", length}, {"triangles", triangles}};
}

}  // namespace seamwise::bench
