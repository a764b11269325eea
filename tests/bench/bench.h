#pragma once
#include <chrono>
#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "alignment/model/matching.h"
#include "problem/prepare.h"
#include "solve/result.h"
#include "solve/solver.h"

/// What `npm run bench` measures, natively and in WebAssembly by the same code. Every task is a
/// JSON object, and so is what it gives. Times are milliseconds, fits cm2, memory bytes.
namespace seamwise::bench {

using Json = nlohmann::ordered_json;

class Watch {
 public:
  /// Since the watch was made. [ms]
  double milliseconds() const {
    return std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

/// The most memory in use since it was made, beyond what was in use then; in WebAssembly, whose
/// memory never shrinks, beyond what was in use when the program started. [bytes]
class PeakMemory {
 public:
  PeakMemory();
  double bytes() const;

 private:
  double before_;
};

/// Of the matrix of a grid of 90 x 90 nodes with 2 unknowns each, its numerical part; the quickest
/// of several. What is not solved by factorisations is measured in these. [ms]
double gridFactorisation();

/// The problem of a task, from its fields garment and print (files), symmetry, method, seed,
/// options, edgeLength (cm, even where an options file may not go), and evenSeams: no seam weighs
/// more than another and no marked lines count, so that the fit is just what is searched for.
/// Throws a sentence.
/// @param print_scale, print_turn   how much larger than in its file, and turned, the print is; rad
Problem problemOf(const Json& task, double print_scale = 1, double print_turn = 0);

/// The value, or its error thrown as a sentence.
template <class T>
T required(Outcome<T> outcome) {
  if (!outcome.ok()) throw std::runtime_error(outcome.error().message);
  return std::move(outcome).value();
}

MatchRules rulesOf(const Problem& problem);
int trianglesOf(const Pattern& pattern);

/// A solve and what it took.
struct Timed {
  Result result;
  double prepare = 0, alignment = 0, deformation = 0, measuring = 0;  ///< ms
  double earlier = 0;  ///< ms: attempts with other weights, which do not count
  double first = 0;    ///< ms until the first alignment that can be drawn
  double first_fit = 0;
  double cold_first = 0;   ///< ms: as `first`, of the first of the solves it was chosen from
  double peak_memory = 0;  ///< bytes, of that one as well
  bool monotone = true;    ///< whether the progress reported never fell
  double astray = 0;  ///< greatest distance of the progress reported from the share of time spent
  double total() const { return prepare + alignment + deformation + measuring; }
};

/// @param make   makes the problem; part of what is timed
/// @param memo   of the solve before it; a mesh that has not changed is taken from there
Timed timedSolve(const std::function<Problem()>& make, const SolveMemo& memo = {});

/// The quickest of as many solves as the task asks for in `times`, and more until `atLeast` ms are
/// spent: an engine compiles WebAssembly once more, and better, while it runs. What users meet
/// once, the first answer and the memory, is also told of the first one.
Timed quickest(const Json& task, const std::function<Problem()>& make, const SolveMemo& memo = {});

Json solveTask(const Json& task);
Json meshTask(const Json& task);
Json factoriseTask(const Json& task);
Json startsTask(const Json& task);
Json searchTask(const Json& task);
Json editTask(const Json& task);
Json drapeTask(const Json& task);
Json markerTask(const Json& task);

}  // namespace seamwise::bench
