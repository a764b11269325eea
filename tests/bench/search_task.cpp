// Result of the search against many random starts and against itself with much more time.
#include <algorithm>
#include <cmath>

#include "alignment/icp/refine.h"
#include "alignment/search/candidates.h"
#include "alignment/search/search.h"
#include "bench.h"
#include "methods/metrics.h"

namespace seamwise::bench {
namespace {

/// Alignment problem of a garment, as the search gets it.
struct Searchable {
  Problem problem;
  Pattern pattern;
  MatchProblem match;

  explicit Searchable(const Json& task)
      : problem(problemOf(task)),
        pattern(required(Solver::make(problem)).pattern()),
        match(makeMatchProblem(pattern, restShapes(pattern), pattern.mirrors, rulesOf(problem),
                               problem.print.group)) {}

  double fit(const Alignments& leaders) const {
    return totalMismatch(problem.print.group, pattern, restShapes(pattern),
                         match.expanded(leaders));
  }
};

constexpr int kIterations = 30;  ///< most of a start; they usually end sooner
constexpr std::size_t kPolished = 10;
constexpr double kNothing = 1e-3;  ///< cm2: no better mismatch is possible

/// Mismatches after the local step of the method `best` from every start, and of the best few after
/// it on every edge.
struct Starts {
  std::vector<double> fits;  ///< ascending
  double milliseconds = 0;
};

Starts randomStarts(const Searchable& garment, int count, std::uint64_t seed) {
  const MatchProblem& match = garment.match;
  Random random(seed);
  Starts starts;
  const Watch watch;
  const double spacing = match.group.reducedBasis()[0].norm() / SearchBudget{}.samples;
  const SampledSeams<float> samples(match, spacing);
  std::vector<int> all;
  for (std::size_t l = 0; l < match.leaders.size(); ++l) all.push_back(static_cast<int>(l));
  std::vector<std::pair<double, Alignments>> ends;
  for (int k = 0; k < count; ++k) {
    Alignments at;
    for (const int l : all) at.push_back(randomAlignment(match, l, random));
    const double cost = refine(match, samples, at, all, kIterations);
    ends.emplace_back(cost, std::move(at));
  }
  std::sort(ends.begin(), ends.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  const SampledSeams<double> exact(match, 0);
  for (std::size_t k = 0; k < std::min(kPolished, ends.size()); ++k)
    refine(match, exact, ends[k].second, all, kIterations);
  starts.milliseconds = watch.milliseconds();
  for (const auto& [cost, at] : ends) starts.fits.push_back(garment.fit(at));
  std::sort(starts.fits.begin(), starts.fits.end());
  return starts;
}

/// Continues from an answer for `milliseconds`, with budgets large enough for that time.
Alignments searchedOn(const MatchProblem& match, const Alignments& known, double milliseconds,
                      std::uint64_t seed) {
  SearchBudget budget;
  budget.idle = budget.hits = 1000000;  // only `evaluations` ends it
  Alignments best = known;
  const Watch all;
  for (double left = milliseconds; left > 0 && match.cost(best) > kNothing; ++seed) {
    const Watch watch;
    AlignmentSearch search(match, seed, budget);
    search.offer(best);
    while (search.step()) {
    }
    best = search.best();
    left = milliseconds - all.milliseconds();
    budget.evaluations *= left / watch.milliseconds();
  }
  return best;
}

}  // namespace

Json startsTask(const Json& task) {
  const Searchable garment(task);
  const int count = task.value("count", 1000);
  const Starts starts = randomStarts(garment, count, task.value("seed", 1u));
  return {{"count", count},
          {"best", starts.fits.front()},
          {"median", starts.fits[starts.fits.size() / 2]},
          {"milliseconds", starts.milliseconds}};
}

/// Solves a task. With `long` milliseconds, it runs the search of the default budget once more with
/// that much time.
Json searchTask(const Json& task) {
  const Timed solved = quickest(task, [&] { return problemOf(task); });
  Json answer = {{"fitSearch", solved.result.total_search},
                 {"milliseconds", solved.alignment},
                 {"bound", solved.result.search_bound}};
  const double time = task.value("long", 0.0);
  if (time <= 0) return answer;
  const Searchable garment(task);
  const Watch watch;
  const Alignments best = searchedOn(garment.match, garment.match.ofLeaders(solved.result.search),
                                     time, task.value("seed", 1u) + 1000);
  answer["longFit"] = garment.fit(best);
  answer["longMilliseconds"] = watch.milliseconds();
  return answer;
}

}  // namespace seamwise::bench
