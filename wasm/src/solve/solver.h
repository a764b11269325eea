#pragma once
#include <memory>
#include <string>
#include <vector>

#include "alignment/search_memo.h"
#include "solve/prepare.h"
#include "solve/problem.h"
#include "solve/result.h"
#include "solve/run.h"

namespace seamwise {

/// What a solve leaves for the next one, which mostly differs in one thing. With it or without,
/// results are the same.
struct SolveMemo {
  MeshMemo mesh;
  SearchMemo searches;
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

 private:
  struct State;
  explicit Solver(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// One-off: tests, batch jobs.
Outcome<Result> solve(Problem problem);

}  // namespace seamwise
