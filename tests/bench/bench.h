#pragma once
#include <chrono>
#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "alignment/model/matching.h"
#include "problem/prepare.h"
#include "solve/result.h"
#include "solve/solver.h"

/// Tasks of `npm run bench`, which runs the same code natively and in WebAssembly. Every task and
/// every answer is a JSON object. Times are in milliseconds, mismatches in cm2, memory in bytes.
namespace seamwise::bench {

using Json = nlohmann::ordered_json;

class Watch {
 public:
  /// Time since the construction. [ms]
  double milliseconds() const {
    return std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

/// Peak memory since the construction, less the memory in use at that time. WebAssembly's memory
/// never shrinks, so there it is measured from the start of the program. [bytes]
class PeakMemory {
 public:
  PeakMemory();
  double bytes() const;

 private:
  double before_;
};

/// Time of the numerical factorisation of the matrix of a grid of 90 x 90 nodes with 2 unknowns
/// each; the quickest of several. Work without factorisations is measured in this unit. [ms]
double gridFactorisation();

/// Builds the problem of a task from its fields garment and print (files), symmetry, method, seed,
/// options, edgeLength (cm, also beyond the range of options files) and evenSeams. With evenSeams,
/// all seams weigh the same and marked lines don't count, so that the mismatch is exactly what the
/// search minimises. Throws std::runtime_error with a message.
/// @param print_scale, print_turn   factor and rotation of the print relative to its file; rad
Problem problemOf(const Json& task, double print_scale = 1, double print_turn = 0);

/// Returns the value, or throws the error's message.
template <class T>
T required(Outcome<T> outcome) {
  if (!outcome.ok()) throw std::runtime_error(outcome.error().message);
  return std::move(outcome).value();
}

MatchRules rulesOf(const Problem& problem);
int trianglesOf(const Pattern& pattern);

/// Result of a solve with its times and memory.
struct Timed {
  Result result;
  double prepare = 0, alignment = 0, deformation = 0, measuring = 0;  ///< ms
  double earlier = 0;  ///< ms: attempts with other weights, which do not count
  double first = 0;    ///< ms until the first alignment that can be drawn
  double first_fit = 0;
  double cold_first = 0;   ///< ms: `first` of the first of the repeated solves
  double peak_memory = 0;  ///< bytes, of the first of the repeated solves
  bool monotone = true;    ///< the reported progress never fell
  double astray = 0;  ///< greatest difference of the reported progress and the share of time spent
  double total() const { return prepare + alignment + deformation + measuring; }
};

/// @param make   creates the problem; part of the measured time
/// @param memo   of the previous solve; unchanged meshes are reused
Timed timedSolve(const std::function<Problem()>& make, const SolveMemo& memo = {});

/// Returns the quickest of `times` solves, a field of the task, and of further ones until `atLeast`
/// ms are spent: engines compile WebAssembly again, and better, while it runs. The first answer's
/// time and the memory, which users meet only once, are those of the first solve.
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
