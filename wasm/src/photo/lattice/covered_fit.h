#pragma once
#include <optional>
#include <vector>

#include "photo/lattice/hidden_places.h"
#include "photo/lattice/lattice_fit.h"

namespace seamwise {

/// Aligns a lattice on an image of which a part is hidden, step by step. Fits from the view's focus
/// alternate with looking for the hidden places, which the next fit omits.
class CoveredFit {
 public:
  /// @param levels   have to outlive the fit, which leaves them without hidden places
  CoveredFit(std::vector<ChannelImage>& levels, const TiltedLattice& start);

  /// Runs one step; returns false when done.
  bool advance();
  const FittedLattice& result() const { return fitted_; }
  const HiddenPlaces& hidden() const { return hidden_; }

 private:
  std::vector<ChannelImage>& levels_;
  FittedLattice fitted_;
  HiddenPlaces hidden_;
  std::optional<LatticeFit> fit_;
  std::size_t stage_ = 0;
};

/// Omits hidden places from an image at all its sizes; null omits none.
void hide(std::vector<ChannelImage>& levels, const HiddenPlaces* hidden);

}  // namespace seamwise
