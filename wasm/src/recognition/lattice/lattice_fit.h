#pragma once
#include <array>
#include <span>

#include "recognition/base/normal_matrix.h"
#include "recognition/lattice/copies.h"

namespace seamwise {

/// What of a `TiltedLattice` is fitted: its basis, the tilt too, the lens too.
enum class FitUnknowns : int { kBasis = 4, kTilt = 6, kLens = 7 };

/// One step of Gauss-Newton towards the map through which all copies look most alike: least of
/// sum w |copy - mean of the copies|^2, the mean taken anew for every map, which is what comparing
/// each copy with the others minimises as well.
struct FitStep {
  std::array<double, 7> gradient{};  ///< half of the sum's derivative
  NormalMatrix normal{};             ///< J^T J
  double sum = 0;                    ///< of the squares
  double count = 0;                  ///< of weighted samples, less those of the means
};

/// The sum's linearisation at a view: basis (row by row), tilt, lens.
/// @param copies   sampled through the same view, with slopes; `weights` count
FitStep linearised(const Copies& copies, const TiltedLattice& view);

/// Weights 1 / (1 + (|e| / 3 m)^2), m the mean |e|, so that what a copy alone has does not count.
void downweigh(Copies& copies);

/// How a map is fitted: first near the middle, where a guess of the basis is good enough.
struct FitStage {
  double reach;  ///< cells from the middle
  int n;         ///< samples along a cell
  FitUnknowns unknowns;
  int steps;  ///< at most
};

struct FittedLattice {
  TiltedLattice view;
  Vec2 uncertainty = Vec2::Zero();  ///< standard errors of |w1|, |w2| as shares of them
};

/// Fits a view in some stages, step by step, until steps move the farthest copy by less than 0.02
/// of a sample.
class LatticeFit {
 public:
  /// @param levels   the picture at falling sizes, each half the one before; outlive this, as
  /// @param stages   do
  LatticeFit(const std::vector<ChannelImage>& levels, const TiltedLattice& start,
             std::span<const FitStage> stages)
      : levels_(levels), stages_(stages), fitted_{start} {}

  /// One step of Gauss-Newton; false when nothing is left to do.
  bool advance();
  const FittedLattice& result() const { return fitted_; }

 private:
  bool step(const FitStage& stage);

  const std::vector<ChannelImage>& levels_;
  std::span<const FitStage> stages_;
  FittedLattice fitted_;
  std::size_t stage_ = 0;
  int step_ = 0;
};

/// Which of the levels to sample cells of `view` on, n to a side.
const ChannelImage& levelFor(const std::vector<ChannelImage>& levels, const TiltedLattice& view,
                             int n);

}  // namespace seamwise
