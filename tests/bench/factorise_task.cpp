// Yardstick for times: one factorisation of a garment's complete mesh.
#include <algorithm>

#include "bench.h"
#include "deform/terms.h"
#include "problem/prepare.h"

namespace seamwise::bench {
namespace {

constexpr double kPull = 0.01;  ///< weight that pulls every vertex to its place, per cm2

/// Triangles in the numbers of all vertices of all pieces, and the rest positions.
struct Whole {
  std::vector<std::array<int, 3>> triangles;
  std::vector<Vec2> rest;
};

Whole wholeOf(const Pattern& pattern) {
  Whole whole;
  for (const Piece& piece : pattern.pieces) {
    const int first = static_cast<int>(whole.rest.size());
    for (const auto& [i, j, k] : piece.triangles)
      whole.triangles.push_back({first + i, first + j, first + k});
    whole.rest.insert(whole.rest.end(), piece.rest.begin(), piece.rest.end());
  }
  return whole;
}

std::vector<std::pair<int, int>> coupled(const Whole& whole) {
  std::vector<std::pair<int, int>> pairs;
  for (const auto& t : whole.triangles)
    for (int a = 0; a < 6; ++a)
      for (int b = 0; b < a; ++b) pairs.emplace_back(2 * t[a / 2] + a % 2, 2 * t[b / 2] + b % 2);
  return pairs;
}

}  // namespace

/// Factorises conformal energy and a pull to rest with two unknowns a vertex. The quickest of
/// several runs counts, as with solves: an engine that is still optimising would lengthen the
/// yardstick.
Json factoriseTask(const Json& task) {
  Problem problem = problemOf(task);
  const Pattern pattern = required(prepared(problem)).pattern;
  const Whole whole = wholeOf(pattern);
  const int unknowns = 2 * static_cast<int>(whole.rest.size());
  const auto pairs = coupled(whole);
  std::vector<ConformalTriangle> triangles;
  VectorX x(unknowns);
  for (const auto& t : whole.triangles)
    triangles.push_back(conformalTriangle(t, whole.rest[t[0]], whole.rest[t[1]], whole.rest[t[2]]));
  for (std::size_t v = 0; v < whole.rest.size(); ++v) x.segment<2>(2 * v) = whole.rest[v];
  double symbolic = 1e300, numeric = 1e300;
  const int times = task.value("times", 1);
  const double long_enough = task.value("atLeast", 0.0);
  const Watch watch;
  for (int k = 0; k < times || watch.milliseconds() < long_enough; ++k) {
    const Watch analysing;
    SparseHessian hessian(unknowns, pairs);
    hessian.analyse();
    symbolic = std::min(symbolic, analysing.milliseconds());
    hessian.setZero();
    conformalEnergy(triangles, x, 1, nullptr, &hessian);
    for (int i = 0; i < unknowns; ++i) hessian.add(i, i, 2 * kPull);
    const Watch factorising;
    if (!hessian.factorise()) throw std::runtime_error("The whole mesh could not be factorised.");
    numeric = std::min(numeric, factorising.milliseconds());
  }
  return {{"triangles", trianglesOf(pattern)},
          {"unknowns", unknowns},
          {"symbolic", symbolic},
          {"numeric", numeric}};
}

}  // namespace seamwise::bench
