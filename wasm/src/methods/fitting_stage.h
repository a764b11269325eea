#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "deform/fitting.h"
#include "methods/run.h"

namespace seamwise {

/// An alignment of the leaders to fit from.
struct FittingStart {
  Alignments leaders;
  bool stays = false;  ///< only shapes change, no piece is placed anew
};

/// Shape and alignment improved in turns: a few steps from each of several answers of the search,
/// then on from the best one. Where edges are short this happens on a coarser mesh, and the whole
/// one only takes the last steps. Seams that shaping cannot bring to meet keep their drafted lines
/// and pull nothing: once they are known, shapes start again without them. A start that leaves
/// seams worse off than placing alone does is given up for the next; where none is left, the one
/// that came closest may go on. Seam lengths and limits are left to settle.
class FittingStage {
 public:
  /// All but the starts outlives the run.
  /// @param match    of the pattern at rest, made by the rules
  /// @param plans    for the pattern
  /// @param starts   at least one; the last stays: what placing alone ends with
  /// @param reach    how far an outline vertex may move. [cm]
  FittingStage(const Pattern& pattern, const MatchProblem& match, const MatchRules& rules,
               const FittingRules& fitting, FittingPlans& plans, std::vector<FittingStart> starts,
               double reach);

  /// One step of all parts. False when there is nothing left to do.
  bool advance();
  double fraction() const;  ///< 0..1, never falls
  /// Whether the print meets everywhere as the pieces lie, so that nothing has to move.
  bool isPerfect() const { return perfect_; }

  /// Whether another start is needed: none has led to shapes that leave every seam as good as
  /// placing alone does. Then goOn() has to be called before the next step.
  bool needsStart() const { return needs_start_; }
  /// Factor, per seam, of its weight in the search for another start.
  const std::vector<double>& searchFactors() const { return search_factors_; }
  /// Goes on with another start, or without.
  void goOn(std::optional<Alignments> leaders);

  /// Judges the seams of settled shapes. False when one is worse off than by placing alone or bent
  /// in vain; then there are more steps to take, or nothing but lengths is left to settle.
  bool review();

  const Alignments& alignment() const { return alignment_; }  ///< of every piece
  SeamFitting& fitting() { return *fitting_; }                ///< at the end: of the pattern
  int iterations() const { return iterations_; }
  int factorisations() const;

 private:
  enum class Judgement : std::uint8_t { kGood, kOtherPulls, kFailed };
  /// How far a start has come.
  struct Start : FittingStart {
    std::vector<PartDeformation::State> states;
    std::vector<char> shaped;          ///< per seam: it pulls
    std::vector<double> pull_factors;  ///< per seam: multiple of its weight
    std::vector<double> margins;  ///< per seam: by how much it is held below what is allowed. [cm]
    /// Total after its last steps: as it is, and under the rules. [cm2]
    std::optional<double> mismatch, mismatch_under_rules;
    int steps = 0, rounds = 0, reviews = 0;
    bool ended = false, failed = false;
    /// By how much the worst seam exceeded what it may miss by when it failed, as a share of that.
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
  void pull();
  Judgement judge();
  void giveUp();
  bool dropNeighbours(std::size_t seam);

  const Pattern& pattern_;
  const MatchProblem& match_;
  const MatchRules& rules_;
  FittingRules fitting_rules_;
  FittingPlans& plans_;
  double reach_;
  Alignments placed_;  ///< of every piece, by placing alone
  std::unique_ptr<SeamFitting> fine_, coarse_fitting_;
  SeamFitting* fitting_;  ///< at work
  const CoarserPlan* plan_ = nullptr;
  bool coarse_ = false;     ///< whether the coarser mesh is at work
  Pattern coarse_pattern_;  ///< with the seams' present weights
  std::vector<Start> starts_;
  std::size_t current_ = 0;  ///< of the starts
  Alignments leaders_, alignment_;
  std::vector<double> search_factors_;  ///< per seam, see searchFactors()
  std::vector<char> worse_;             ///< per seam: by the last judgement
  double excess_ = 0;                   ///< of the worst of them, as in Start
  bool perfect_ = false, begun_ = false, needs_start_ = false, may_seek_ = true, given_up_ = false;
  bool stalled_ = false;             ///< the best start has no steps left to take
  int steps_ = 0, trial_steps_ = 0;  ///< to do, all and from each start
  int fine_steps_ = 0;               ///< to do, after coarse ones
  int reviews_ = 0;                  ///< of settled shapes
  int iterations_ = 0;
  double done_ = 0, planned_ = 1;  ///< steps, in coarse ones
  double fine_step_ = 1;           ///< coarse ones that take as long as a fine one
};

}  // namespace seamwise
