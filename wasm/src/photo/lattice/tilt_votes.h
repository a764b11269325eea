#pragma once
#include <array>
#include <vector>

#include "photo/lattice/channel_image.h"
#include "photo/lattice/hidden_places.h"
#include "photo/lattice/tilted_lattice.h"
#include "photo/lattice/tilted_planes.h"

namespace seamwise {

/// Candidate for the print's lattice.
struct LatticeHypothesis {
  TiltedLattice view;
  double score = 0;  ///< mean correlation at its points
  bool is_stripes = false;
  // Valid once aligned:
  double explained = 0;             ///< see `LatticeReading`
  Vec2 uncertainty = Vec2::Zero();  ///< see `FittedLattice`
  double repeated = 0;              ///< 1 if a repeat is seen twice both ways, 0 if once
  HiddenPlaces hidden;
};

/// Autocorrelates an image under various assumed tilts of the fabric, because perspective smears
/// the peaks of the whole image beyond some 8 degrees. It also uses parts around the image's
/// middle, in which small repeats appear larger. For images with an object on the fabric it uses
/// other parts, too, in which no block has more contrast than others. Each of these steps votes for
/// lattices.
class TiltVotes {
 public:
  /// Number of the first steps, whose tilts cover most photos.
  static constexpr int kUsual = 9;
  /// Number of the first steps with those that find a print beside an object.
  static constexpr int kBeside = kUsual + 9;

  /// @param levels   image at decreasing sizes, each half the previous one; has to outlive the
  ///                 object
  explicit TiltVotes(const std::vector<ChannelImage>& levels);

  int count() const { return static_cast<int>(parts_.size()); }
  /// Runs step k, below count().
  void vote(int k);
  /// Returns all distinct lattices so far, the highest score first.
  std::vector<LatticeHypothesis> ranked() const;
  /// Highest score on the half around the middle.
  double bestOfMiddle() const { return best_of_middle_; }

 private:
  void add(const LatticeHypothesis& hypothesis);

  const std::vector<ChannelImage>& levels_;
  std::array<std::array<float, 3>, 2> axes_{};
  std::vector<TiltedPart> parts_;
  std::vector<LatticeHypothesis> hypotheses_;
  double best_of_middle_ = 0;
};

/// Returns whether two views show the same lattice at the image's middle, within `tolerance` of w1,
/// w2.
bool isSameLattice(const TiltedLattice& a, const TiltedLattice& b, double tolerance);

}  // namespace seamwise
