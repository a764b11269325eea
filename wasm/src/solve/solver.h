#pragma once
#include <memory>
#include <string>
#include <vector>

#include "alignment/search/search_memo.h"
#include "methods/run.h"
#include "methods/run_memo.h"
#include "problem/prepare_symmetric.h"
#include "problem/problem.h"
#include "solve/result.h"

namespace seamwise {

/// Intermediate results of a solve for reuse by the next one, which mostly differs in one setting.
/// Reusing them does not change the result.
struct SolveMemo {
  MeshMemo mesh;
  SearchMemo searches;
  RunMemo runs;
};

/// Proven bound on the cost of alignments of the pieces as drafted.
struct Proven {
  double bound = 0;        ///< no alignment costs less than this share of the best one found
  double search_cost = 0;  ///< Result::search_cost of the best one, after the search. [cm2]
};

/// A solve in small steps, so that progress is accurate and cancelling needs no threads.
class Solver {
 public:
  /// Samples and meshes the garment. Errors: kMesh, kSymmetryConflict.
  /// @param memo   memo of earlier solves, which must outlive the solver; null: nothing is reused
  static Outcome<Solver> make(Problem problem, SolveMemo* memo = nullptr);
  Solver(Solver&&) noexcept;
  Solver& operator=(Solver&&) noexcept;
  ~Solver();

  /// Makes at most `steps` steps of a few milliseconds. Returns false when finished.
  bool advance(int steps);
  Phase phase() const;
  double fraction() const;  ///< 0..1, monotone
  /// Number of the attempt, which grows when the deformation restarts. The time of earlier attempts
  /// does not count.
  int attempt() const;
  const Alignments& partial() const;  ///< best alignment so far, of every piece
  /// The active search between two steps, which can lend shares to workers; null if there is none.
  AlignmentSearch* searching();
  const std::vector<Note>& notes() const;
  const Pattern& pattern() const;

  /// The pieces as drafted, in the drafted layout on the print.
  PrintedPattern unsolved() const;

  /// Makes all remaining steps and returns the result.
  Outcome<Result> finish();

  /// Improves the proven bound, instead of a solve or after it, in at most `steps` steps of some
  /// milliseconds. Returns false when no more can be proven. Only for the default method.
  bool prove(int steps);
  /// The bound proven so far.
  Proven proven() const;

 private:
  friend class SolverSetup;
  struct State;
  explicit Solver(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Creates a solver in steps: samples and meshes the garment.
class SolverSetup {
 public:
  /// @param memo   as for Solver::make
  explicit SolverSetup(Problem problem, SolveMemo* memo = nullptr);
  ~SolverSetup();

  /// Works for some milliseconds. Returns false when finished.
  bool advance();
  double fraction() const;  ///< 0..1, monotone
  /// Returns the solver; requires that advance() has returned false. Errors: kMesh,
  /// kSymmetryConflict.
  Outcome<Solver> take();

 private:
  std::unique_ptr<Solver::State> state_;
  SolveMemo* memo_;
  SymmetricPreparation preparation_;
};

/// Solves a problem in one call, for tests and batch jobs.
Outcome<Result> solve(Problem problem);

}  // namespace seamwise
