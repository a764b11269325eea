#pragma once
#include <array>
#include <vector>

#include "recognition/lattice/channel_image.h"
#include "recognition/lattice/tilted_lattice.h"
#include "recognition/lattice/tilted_planes.h"

namespace seamwise {

/// A lattice that may be the print's.
struct LatticeHypothesis {
  TiltedLattice view;
  double score = 0;  ///< mean correlation at its points
  bool is_stripes = false;
  // Once it is aligned:
  double explained = 0;             ///< as `LatticeReading` has it
  Vec2 uncertainty = Vec2::Zero();  ///< as `FittedLattice` has it
};

/// Autocorrelates a picture as if its cloth were tilted this way and that, because perspective
/// smears the peaks of the whole picture beyond some 8 degrees; and parts about its middle, in
/// which small repeats are seen larger. Each votes for lattices.
class TiltVotes {
 public:
  /// How many of the steps below assume a tilt that most photographs keep within.
  static constexpr int kUsual = 9;

  /// @param levels   the picture at falling sizes, each half the one before; outlive this
  explicit TiltVotes(const std::vector<ChannelImage>& levels);

  int count() const { return static_cast<int>(parts_.size()); }
  /// The k-th of them.
  void vote(int k);
  /// All lattices so far, each once, those first that more speaks for.
  std::vector<LatticeHypothesis> ranked() const;
  /// The highest score on the half about the middle.
  double bestOfMiddle() const { return best_of_middle_; }

 private:
  void add(const LatticeHypothesis& hypothesis);

  const std::vector<ChannelImage>& levels_;
  std::array<std::array<float, 3>, 2> axes_{};
  std::vector<TiltedPart> parts_;
  std::vector<LatticeHypothesis> hypotheses_;
  double best_of_middle_ = 0;
};

/// Whether two views show the same lattice at the middle of the picture, within `tolerance` of w1,
/// w2.
bool isSameLattice(const TiltedLattice& a, const TiltedLattice& b, double tolerance);

}  // namespace seamwise
