#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "deform/fitting.h"
#include "methods/run.h"

namespace seamwise {

/// Alignments of the leaders as a start of fitting.
struct FittingStart {
  Alignments leaders;
  bool stays = false;  ///< only shapes change, no alignments
};

/// Improves shape and alignment in turns: a few steps from each of several answers of the search,
/// then more from the best one. If edges are short, a coarser mesh is used, and only the last steps
/// use the whole one. Seams that shaping cannot make meet keep their drafted lines and have no
/// pull; once these are known, shapes start again without them. A start fails if it leaves seams
/// worse off than placing alone, and the next one follows. If none remains, the one that failed by
/// least may continue. Seam lengths and limits have to settle afterwards.
class FittingStage {
 public:
  /// All arguments except the starts outlive the run.
  /// @param match    of the pattern at rest, under the rules
  /// @param plans    for the pattern
  /// @param starts   at least one; the last one stays: the answer of placing alone
  /// @param reach    greatest movement of an outline vertex. [cm]
  FittingStage(const Pattern& pattern, const MatchProblem& match, const MatchRules& rules,
               const FittingRules& fitting, FittingPlans& plans, std::vector<FittingStart> starts,
               double reach);

  /// Takes one step of all parts. Returns false when no steps remain.
  bool advance();
  double fraction() const;  ///< 0..1, never falls
  /// Returns whether the print meets everywhere with the drafted pieces, so no shape has to change.
  bool isPerfect() const { return perfect_; }

  /// Returns whether another start is needed, because no shapes so far leave every seam as good as
  /// placing alone. goOn() has to be called before the next step then.
  bool needsStart() const { return needs_start_; }
  /// Factor of each seam's weight in the search for another start.
  const std::vector<double>& searchFactors() const { return search_factors_; }
  /// Continues with another start, or without one.
  void goOn(std::optional<Alignments> leaders);

  /// Judges the seams of settled shapes. Returns false if one is worse off than by placing alone or
  /// bent in vain; then more steps remain, or only lengths have to settle.
  bool review();

  const Alignments& alignment() const { return alignment_; }  ///< alignment of every piece
  SeamFitting& fitting() { return *fitting_; }                ///< finally on the pattern's own mesh
  int iterations() const { return iterations_; }
  int factorisations() const;

 private:
  enum class Judgement : std::uint8_t { kGood, kOtherPulls, kFailed };
  /// The progress of a start.
  struct Start : FittingStart {
    std::vector<PartDeformation::State> states;
    std::vector<char> shaped;          ///< per seam: 1 if it pulls
    std::vector<double> pull_factors;  ///< per seam: multiple of its weight
    /// Per seam: multiple of its weight in the last steps, by how nearly it matches; empty before.
    std::vector<double> favours;
    std::vector<double> margins;  ///< per seam: reduction of its limit. [cm]
    /// Total mismatch after its last steps, plain and under the rules. [cm2]
    std::optional<double> mismatch, mismatch_under_rules;
    int steps = 0, rounds = 0, reviews = 0;
    bool ended = false, failed = false;
    /// Excess of the worst seam over its limit when the start failed, as a share of that limit.
    double excess = 0;
    bool retried = false;
  };
  const Pattern& fitted() const { return coarse_ ? coarse_pattern_ : pattern_; }
  void add(FittingStart from);
  void begin();
  void goCoarse();
  void goFine();
  bool isWorseThanPlaced() const;
  void resume(std::size_t index);
  void again();
  bool endSteps();
  void fail();
  bool leave();
  bool goOnFromBest();
  bool retryNearest();
  void place(const Alignments& leaders);
  void realign();
  std::vector<double> placedMismatches() const;
  double factorOf(std::size_t seam) const;
  void pull();
  void favourNearMatches();
  Judgement judge();
  void giveUp();
  bool dropNeighbours(std::size_t seam);

  const Pattern& pattern_;
  const MatchProblem& match_;
  const MatchRules& rules_;
  FittingRules fitting_rules_;
  FittingPlans& plans_;
  double reach_;
  Alignments placed_;  ///< alignment of every piece by placing alone
  std::unique_ptr<SeamFitting> fine_, coarse_fitting_;
  SeamFitting* fitting_;  ///< current fitting
  const CoarserPlan* plan_ = nullptr;
  bool coarse_ = false;     ///< true while the coarser mesh is in use
  Pattern coarse_pattern_;  ///< has the seams' current weights
  std::vector<Start> starts_;
  std::size_t current_ = 0;  ///< index of the current start
  Alignments leaders_, alignment_;
  std::vector<double> search_factors_;  ///< per seam, see searchFactors()
  std::vector<char> worse_;             ///< per seam: 1 if worse off at the last judgement
  double excess_ = 0;                   ///< excess of the worst of them, as in Start
  bool perfect_ = false, begun_ = false, needs_start_ = false, may_seek_ = true, given_up_ = false;
  bool stalled_ = false;             ///< the best start has no steps left
  int steps_ = 0, trial_steps_ = 0;  ///< number of steps: all, and as a trial of each start
  int fine_steps_ = 0;               ///< remaining steps on the fine mesh, after coarse ones
  int reviews_ = 0;                  ///< number of reviews of settled shapes
  int iterations_ = 0;
  double done_ = 0, planned_ = 1;  ///< number of steps, in coarse ones
  double fine_step_ = 1;           ///< number of coarse steps that take as long as a fine one
};

}  // namespace seamwise
