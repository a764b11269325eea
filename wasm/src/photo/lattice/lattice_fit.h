#pragma once
#include <array>
#include <span>

#include "photo/base/normal_matrix.h"
#include "photo/lattice/copies.h"

namespace seamwise {

/// Fitted unknowns of a `TiltedLattice`: its basis; the tilt too; the lens too.
enum class FitUnknowns : int { kBasis = 4, kTilt = 6, kLens = 7 };

/// Gauss-Newton step towards the map through which all copies look most alike. It minimises the sum
/// w |copy - mean of the copies|^2, with a new mean for every map. This also minimises the
/// differences of each copy from the others.
struct FitStep {
  std::array<double, 7> gradient{};  ///< half of the sum's derivative
  NormalMatrix normal{};             ///< J^T J
  double sum = 0;                    ///< sum of the squares
  double count = 0;                  ///< weighted samples less those of the means
};

/// Linearises the sum at a view: basis (row by row), tilt, lens.
/// @param copies   sampled through the same view, with slopes; `weights` count
FitStep linearised(const Copies& copies, const TiltedLattice& view);

/// Multiplies weights by 1 / (1 + (|e| / 3 m)^2), m the mean |e|, so that the content of a single
/// copy does not count.
void downweigh(Copies& copies);

/// Stage of a fit. The first stages stay near the middle, where a guess of the basis is accurate
/// enough.
struct FitStage {
  double reach;  ///< cells from the middle
  int n;         ///< samples along a cell
  FitUnknowns unknowns;
  int steps;  ///< maximum number of steps
};

struct FittedLattice {
  TiltedLattice view;
  Vec2 uncertainty = Vec2::Zero();  ///< standard errors of |w1|, |w2|, as shares
};

/// Fits a view in stages, step by step, until a step moves the farthest copy by less than 0.02 of a
/// sample.
class LatticeFit {
 public:
  /// @param levels   image at decreasing sizes, each half the previous one; has to outlive the fit
  /// @param stages   have to outlive the fit
  LatticeFit(const std::vector<ChannelImage>& levels, const TiltedLattice& start,
             std::span<const FitStage> stages)
      : levels_(levels), stages_(stages), fitted_{start} {}

  /// Runs one Gauss-Newton step; returns false when done.
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

/// Returns the level on which to sample cells of `view`, n samples per side.
const ChannelImage& levelFor(const std::vector<ChannelImage>& levels, const TiltedLattice& view,
                             int n);

}  // namespace seamwise
