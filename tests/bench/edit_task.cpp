// Time until a change to a solved problem shows: the first and the final answer.
#include <algorithm>

#include "bench.h"

namespace seamwise::bench {
namespace {

constexpr double kWeight = 3, kScale = 1.02, kTurn = 2 * kPi / 180, kShift = 1;

double lengthOf(const Pattern& pattern, const SeamSide& side) {
  const std::vector<Vec2>& rest = pattern.pieces[side.piece].rest;
  double length = 0;
  for (std::size_t i = 1; i < side.vertices.size(); ++i)
    length += (rest[side.vertices[i]] - rest[side.vertices[i - 1]]).norm();
  return length;
}

/// Returns the longest matched seam.
int weightiest(const Pattern& pattern) {
  int longest = 0;
  double length = -1;
  for (std::size_t s = 0; s < pattern.seams.size(); ++s) {
    const Seam& seam = pattern.seams[s];
    const double own = seam.matched && !seam.twin ? lengthOf(pattern, seam.a) : 0;
    if (own > length) length = own, longest = static_cast<int>(s);
  }
  return longest;
}

/// Returns a piece to pin and its alignment: a piece without an axis, slightly shifted; otherwise
/// the first piece, unshifted.
std::pair<int, Alignment> pinOf(const Result& solved) {
  std::vector<char> symmetric(solved.pattern.pieces.size());
  for (const Mirror& m : solved.pattern.mirrors)
    if (m.single()) symmetric[m.pieces[0]] = 1;
  const auto loose = std::find(symmetric.begin(), symmetric.end(), 0);
  if (loose == symmetric.end()) return {0, solved.alignment[0]};
  const int piece = static_cast<int>(loose - symmetric.begin());
  Alignment at = solved.alignment[piece];
  at.translation.x() += kShift;
  return {piece, at};
}

}  // namespace

/// Solves as a worker does, with the memo of the previous solve.
Json editTask(const Json& task) {
  Json with = task, without = task;
  with["symmetry"] = "auto", without["symmetry"] = "none";
  const Timed before = timedSolve([&] { return problemOf(task); });
  const int seam = weightiest(before.result.pattern);
  const auto [pinned, at] = pinOf(before.result);
  const auto memoOf = [](const Json& solved) {
    SolveMemo memo;
    required(required(Solver::make(problemOf(solved), &memo)).finish());
    return memo;
  };
  const SolveMemo memo = memoOf(task);
  Json changes = Json::object();
  auto change = [&](const char* name, const std::function<Problem()>& make,
                    const SolveMemo& known) {
    const Timed timed = quickest(task, make, known);
    changes[name] = {{"first", timed.first},
                     {"firstFit", timed.first_fit},
                     {"final", timed.total()},
                     {"fit", timed.result.total.nearest}};
  };
  change(
      "weight",
      [&, s = seam] {
        Problem problem = problemOf(task);
        problem.options.weights[s] = kWeight;
        return problem;
      },
      memo);
  change(
      "size", [&] { return problemOf(task, kScale); }, memo);
  change(
      "turn", [&] { return problemOf(task, 1, kTurn); }, memo);
  change(
      "pin",
      [&, p = pinned, a = at] {
        Problem problem = problemOf(task);
        problem.options.pins[p] = a;
        return problem;
      },
      memo);
  change(
      "symmetryAdded", [&] { return problemOf(with); }, memoOf(without));
  change(
      "symmetryRemoved", [&] { return problemOf(without); }, memoOf(with));
  return {{"triangles", trianglesOf(before.result.pattern)},
          {"fit", before.result.total.nearest},
          {"solve", before.total()},
          {"changes", changes}};
}

}  // namespace seamwise::bench
