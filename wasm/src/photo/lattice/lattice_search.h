#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/outcome.h"
#include "photo/base/lattice_reading.h"
#include "photo/base/picture.h"
#include "photo/lattice/covered_fit.h"
#include "photo/lattice/lattice_fit.h"
#include "photo/lattice/tilt_votes.h"

namespace seamwise {

/// Use of a lattice given by the user: a guess to align, or the answer.
enum class GivenLattice : std::uint8_t { kAlign, kKeep };

/// Finds the lattice of the print in an image, step by step. The image is reduced and its light
/// removed. Its autocorrelation under various assumed tilts of the fabric votes for lattices. These
/// are aligned, and the best one is tested for smaller and larger cells.
class LatticeSearch {
 public:
  explicit LatticeSearch(const PixelView& view);
  /// Starts from a lattice given by the user. The result keeps its basis and origin, except for
  /// changes by alignment with kAlign, and is never rejected.
  LatticeSearch(const PixelView& view, const LatticeMap& given, GivenLattice use);

  LatticeSearch(const LatticeSearch&) = delete;  // members refer to each other
  LatticeSearch& operator=(const LatticeSearch&) = delete;

  /// Runs one step of some 10 ms; returns false when done.
  bool advance();
  double fraction() const;  ///< 0 to 1

  // Results, valid once done:

  /// kPicture, one sentence with the image's fault and a remedy.
  const std::optional<Error>& error() const { return error_; }
  const LatticeReading& result() const { return result_; }
  /// The best lattices, at most three, the result first. The user chooses from them if the result
  /// is uncertain or an error.
  const std::vector<LatticeReading>& candidates() const { return candidates_; }

 private:
  enum class Stage : std::uint8_t {
    kReduce,
    kFlatten,
    kLevels,
    kVote,
    kAlign,
    kSmallestCell,
    kLargerCell,
    kMeasure,
    kDone,
  };
  void reduce();
  void addLevel();
  void vote();
  void align();
  void beginFit(const TiltedLattice& start, std::span<const FitStage> stages);
  void keepAligned(const FittedLattice& fitted, const HiddenPlaces& hidden);
  void chooseBest();
  void findSmallestCell();
  void findLargerCell();
  void measure();
  void finish();
  Agreement agreement(const TiltedLattice& view) const;
  LatticeReading readingOf(const LatticeHypothesis& aligned) const;
  double repeatsOf(const LatticeHypothesis& aligned) const;
  bool mayBeMuchSmaller(const LatticeHypothesis& best) const;

  PixelView pixels_;
  std::optional<LatticeMap> given_;
  GivenLattice use_ = GivenLattice::kAlign;
  Stage stage_ = Stage::kReduce;
  int factor_ = 1, row_ = 0;
  Picture picture_;
  std::vector<ChannelImage> levels_;
  std::optional<TiltVotes> votes_;
  int part_ = 0, part_end_ = 0;
  std::vector<LatticeHypothesis> hypotheses_;
  std::size_t hypothesis_ = 0;
  std::optional<LatticeFit> fit_;
  std::optional<CoveredFit> covered_fit_;
  bool shows_two_prints_ = false;
  std::vector<LatticeHypothesis> aligned_;  ///< best first once one is chosen
  std::optional<Error> error_;
  LatticeReading result_;
  std::vector<LatticeReading> candidates_;
};

}  // namespace seamwise
