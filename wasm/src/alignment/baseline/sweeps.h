#pragma once
#include "alignment/model/matching.h"
#include "base/random.h"
#include "tuning/paper.h"

namespace seamwise {

/// The local iteration of Wolff et al. 2019 (after Jakob et al. 2015), from one random start.
/// Rotations are averaged over the seams of one piece after the other (Eq. 1) until nothing turns,
/// then translations likewise. The symmetry of each piece is restored after its turn or shift (Sec.
/// 3.1; pairs have one variable).
class LocalSweeps {
 public:
  LocalSweeps(const MatchProblem& problem, std::uint64_t seed);
  /// Starts from given alignments, by leader.
  LocalSweeps(const MatchProblem& problem, Alignments start);
  /// Takes one sweep over all pieces. Returns false when it has converged.
  bool step();
  double fraction() const { return static_cast<double>(sweeps_) / (2 * PaperTuning::kMostSweeps); }
  const Alignments& at() const { return at_; }
  int sweeps() const { return sweeps_; }

 private:
  double turn(int leader);   ///< returns the change, rad
  double shift(int leader);  ///< returns the change, cm

  const MatchProblem& problem_;
  Alignments at_;
  bool turning_ = true;
  int sweeps_ = 0, of_this_kind_ = 0;
};

}  // namespace seamwise
