#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "base/outcome.h"
#include "recognition/base/lattice_reading.h"
#include "recognition/base/picture.h"
#include "recognition/lattice/lattice_fit.h"
#include "recognition/lattice/tilted_planes.h"

namespace seamwise {

/// What a lattice that somebody gives is: a guess to be aligned, or the answer.
enum class GivenLattice : std::uint8_t { kAlign, kKeep };

/// Finds the lattice of the print on a picture, step by step: the picture is reduced, its light
/// taken away; its autocorrelation, as if the cloth were tilted this way and that, votes for
/// lattices; these are aligned, and the best one is tested for larger and smaller cells.
class LatticeSearch {
 public:
  explicit LatticeSearch(const PixelView& view);
  /// Begins at a lattice that the user gave.
  LatticeSearch(const PixelView& view, const LatticeMap& given, GivenLattice use);

  /// One step, about 30 ms in WebAssembly at most; false when nothing is left to do.
  bool advance();
  double fraction() const;  ///< 0 to 1

  /// Once all is done. Errors: kPicture, one sentence that says what is wrong with the picture and
  /// what would help.
  const Outcome<LatticeReading>& result() const { return *result_; }
  /// The best lattices, at most three, the result first: for the user to choose from when the
  /// result is uncertain or an error.
  const std::vector<LatticeReading>& candidates() const { return candidates_; }

 private:
  enum class Stage : std::uint8_t {
    kReduce,
    kFlatten,
    kLevels,
    kVote,
    kAlign,
    kCells,
    kMeasure,
    kDone
  };
  struct Hypothesis {
    TiltedLattice view;
    double score = 0;  ///< of the vote
    bool is_stripes = false;
    double explained = 0;  ///< once aligned
    Vec2 uncertainty = Vec2::Zero();
  };

  void reduce();
  void addLevels();
  void vote();
  void addHypothesis(Hypothesis hypothesis);
  void beginAlignment();
  void align();
  void testCells();
  void measure();
  void finish();
  LatticeReading readingOf(const Hypothesis& hypothesis) const;

  PixelView view_;
  std::optional<LatticeMap> given_;
  GivenLattice use_ = GivenLattice::kAlign;
  Stage stage_ = Stage::kReduce;
  int factor_ = 1;
  int row_ = 0;
  Picture picture_;
  std::vector<ChannelImage> levels_;
  std::array<std::array<float, 3>, 2> axes_{};
  std::size_t part_ = 0, part_end_ = 0;
  std::vector<Hypothesis> hypotheses_;  ///< those voted for
  std::vector<Hypothesis> aligned_;
  std::size_t next_ = 0;
  std::optional<Outcome<LatticeReading>> result_;
  std::vector<LatticeReading> candidates_;
};

}  // namespace seamwise
