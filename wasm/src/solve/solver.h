#pragma once
#include <memory>
#include <string>
#include <vector>

#include "alignment/search/search_memo.h"
#include "methods/run.h"
#include "problem/prepare_symmetric.h"
#include "problem/problem.h"
#include "solve/result.h"

namespace seamwise {

/// What a solve leaves for the next one, which mostly differs in one thing. With it or without,
/// results are the same.
struct SolveMemo {
  MeshMemo mesh;
  SearchMemo searches;
};

/// How good alignments of the pieces as drafted can be.
struct Proven {
  double bound = 0;        ///< none costs less than this share of the best one found
  double search_cost = 0;  ///< Result::search_cost of that one, once the search has ended. [cm2]
};

/// A solve in small steps, so that progress is honest and cancelling needs no threads.
class Solver {
 public:
  /// Samples and meshes the garment. Errors: kMesh, kSymmetryConflict.
  /// @param memo   of the solves before; null: all is made anew. Outlives the solver.
  static Outcome<Solver> make(Problem problem, SolveMemo* memo = nullptr);
  Solver(Solver&&) noexcept;
  Solver& operator=(Solver&&) noexcept;
  ~Solver();

  /// At most `steps` steps of a few milliseconds. False when finished.
  bool advance(int steps);
  Phase phase() const;
  double fraction() const;  ///< 0..1, monotone
  /// Grows when the deformation starts over; the time of earlier attempts does not count.
  int attempt() const;
  const Alignments& partial() const;  ///< best alignment so far, of every piece
  /// The search at work between two steps, to lend shares of it; null when there is none.
  AlignmentSearch* searching();
  const std::vector<Note>& notes() const;
  const Pattern& pattern() const;

  /// The pieces as drafted, each lying on the print as it does in the file.
  PrintedPattern unsolved() const;

  /// The finished result; finishes first when steps are left.
  Outcome<Result> finish();

  /// Proves how good alignments can be, instead of a solve or after it: at most `steps` steps of
  /// some milliseconds. False when no more can be proven. Only for the default method.
  bool prove(int steps);
  /// What is proven by then.
  Proven proven() const;

 private:
  friend class SolverSetup;
  struct State;
  explicit Solver(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// A solver in the making, in steps: samples and meshes the garment.
class SolverSetup {
 public:
  /// @param memo   as for Solver::make
  explicit SolverSetup(Problem problem, SolveMemo* memo = nullptr);
  ~SolverSetup();

  /// Some milliseconds of work. False when there is none left.
  bool advance();
  double fraction() const;  ///< 0..1, monotone
  /// Once it has ended. Errors: kMesh, kSymmetryConflict.
  Outcome<Solver> take();

 private:
  std::unique_ptr<Solver::State> state_;
  SolveMemo* memo_;
  SymmetricPreparation preparation_;
};

/// One-off: tests, batch jobs.
Outcome<Result> solve(Problem problem);

}  // namespace seamwise
