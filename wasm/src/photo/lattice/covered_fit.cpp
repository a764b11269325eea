#include "photo/lattice/covered_fit.h"

namespace seamwise {
namespace {

constexpr int kComparedSamples = 20;  // along a cell that is compared with others

constexpr double kHopeless = 0.7;  // hidden share of the compared cells by a wrong lattice

/// A fit, and the cells from the focus that are then compared.
struct CoveredStage {
  std::array<FitStage, 2> fits;
  double compared;
};

constexpr std::array<CoveredStage, 3> kStages{{
    {{{{1.5, 16, FitUnknowns::kBasis, 6}, {2.5, 16, FitUnknowns::kTilt, 6}}}, 4},
    {{{{4, 16, FitUnknowns::kTilt, 6}, {6, 16, FitUnknowns::kTilt, 6}}}, 20},
    {{{{20, 16, FitUnknowns::kTilt, 6}, {20, 16, FitUnknowns::kTilt, 4}}}, 20},
}};

}  // namespace

void hide(std::vector<ChannelImage>& levels, const HiddenPlaces* hidden) {
  for (ChannelImage& level : levels) level.hidden = hidden;
}

CoveredFit::CoveredFit(std::vector<ChannelImage>& levels, const TiltedLattice& start)
    : levels_(levels), fitted_{start} {}

bool CoveredFit::advance() {
  if (stage_ == kStages.size()) return false;
  const CoveredStage& stage = kStages[stage_];
  if (!fit_) fit_.emplace(levels_, fitted_.view, stage.fits);
  hide(levels_, stage_ == 0 ? nullptr : &hidden_);
  const bool goes_on = fit_->advance();
  hide(levels_, nullptr);
  if (goes_on) return true;
  fitted_ = fit_->result();
  fit_.reset();
  hidden_ =
      hiddenPlaces(levelFor(levels_, fitted_.view, kComparedSamples), fitted_.view, stage.compared);
  ++stage_;
  if (hidden_.share_of_compared > kHopeless) {
    hidden_.share = 1;
    stage_ = kStages.size();
  }
  return stage_ < kStages.size();
}

}  // namespace seamwise
