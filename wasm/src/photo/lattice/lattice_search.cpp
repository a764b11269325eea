#include "photo/lattice/lattice_search.h"

#include <algorithm>
#include <cmath>

#include "base/sort_by.h"
#include "photo/lattice/channels.h"
#include "photo/lattice/lattice_stripes.h"
#include "photo/lattice/picture_faults.h"
#include "photo/lattice/primitive_cell.h"
#include "wallpaper/lattice.h"

namespace seamwise {
namespace {

constexpr int kLongest = 1280;          // longer side of the reduced image, 640 at least. [pixels]
constexpr int kSmallestLevel = 150;     // minimum longer side that is halved once more. [pixels]
constexpr int kRowsAtOnce = 64;         // rows of the reduced image per step
constexpr double kLightSpread = 0.16;   // share of the shorter side: light varies more slowly
constexpr int kHypotheses = 6;          // aligned lattices; the right one was never beyond the 4th
constexpr int kBesideHypotheses = 10;   // the same where an object may be on the fabric; chosen
constexpr double kLeastScore = 0.45;    // score beside an object. Prints have 0.6, noise 0.4
constexpr double kWellExplained = 0.6;  // ends the search over tilts. Prints have 0.9, others 0.5
constexpr double kNothing = 0.3;        // explained by chance, without a repeat
constexpr double kAsGood = 0.04;        // loss of explained share accepted for a smaller cell
// Drawn prints have 0.95 and more. Motifs on a lattice, each turned at random, had up to 0.68.
constexpr double kSure = 0.85, kLikely = 0.75;
// A cell may only follow the warp of the fabric if it is kMuchLarger times one that explains nearly
// as much: houndstooth on a body got 20 of its cells for 0.1 more. None of 170 drawn photos has
// such a pair, even if one flower in six differs.
constexpr double kMuchLarger = 5.5, kLittleMore = 0.15;
constexpr double kMostHidden = 0.43;   // share of the image that an object may hide; chosen
constexpr double kLeastOfTwo = 0.2;    // share of an image that is another print's; chosen
constexpr double kMostLeft = 0.5;      // hidden share that a larger cell leaves, of a smaller one's
constexpr double kMostChange = 1.6;    // change of the cell's area beyond which a fit diverged
constexpr double kReach = 20;          // cells from the middle that are aligned
constexpr double kAgreementReach = 8;  // cells from the middle that are compared
constexpr int kAgreementSamples = 28;  // samples along a cell
constexpr std::size_t kCandidates = 3;
constexpr double kSameCandidate = 0.03;  // share of w1, w2
// Errors of 124 drawn photos were 2.5 times the estimate from residuals, because creases displace
// neighbouring copies alike.
constexpr double kCreasesAlike = 2.5;

constexpr std::array<FitStage, 3> kAlignStages{{{1.5, 16, FitUnknowns::kBasis, 6},
                                                {2.5, 16, FitUnknowns::kTilt, 6},
                                                {kReach, 16, FitUnknowns::kTilt, 8}}};
constexpr std::array<FitStage, 1> kCellStages{{{kReach, 24, FitUnknowns::kLens, 4}}};
constexpr std::array<FitStage, 2> kLastStages{
    {{kReach, 32, FitUnknowns::kLens, 6}, {kReach, 48, FitUnknowns::kLens, 4}}};

/// Share of the image that a lattice explains.
double meritOf(const LatticeHypothesis& aligned) {
  return aligned.explained * aligned.repeated * (1 - aligned.hidden.share);
}

double areaOf(const TiltedLattice& view) { return std::abs(view.basis.determinant()); }

}  // namespace

LatticeSearch::LatticeSearch(const PixelView& view) : pixels_(view) {
  factor_ = reductionTo(kLongest, view);
  picture_ = reducedFrame(view, factor_);
}

LatticeSearch::LatticeSearch(const PixelView& view, const LatticeMap& given, GivenLattice use)
    : LatticeSearch(view) {
  given_ = given;
  use_ = use;
}

bool LatticeSearch::advance() {
  switch (stage_) {
    case Stage::kReduce:
      reduce();
      break;
    case Stage::kFlatten:
      flatten(picture_, kLightSpread * std::min(picture_.width, picture_.height));
      stage_ = Stage::kLevels;
      break;
    case Stage::kLevels:
      addLevel();
      break;
    case Stage::kVote:
      vote();
      break;
    case Stage::kAlign:
      align();
      break;
    case Stage::kSmallestCell:
      findSmallestCell();
      break;
    case Stage::kLargerCell:
      findLargerCell();
      break;
    case Stage::kMeasure:
      measure();
      break;
    case Stage::kDone:
      return false;
  }
  return stage_ != Stage::kDone;
}

double LatticeSearch::fraction() const {
  // Shares of the time, measured on images of 12 million pixels.
  const double votes = votes_ ? static_cast<double>(part_) / part_end_ : 0;
  const double aligned = static_cast<double>(hypothesis_) / kHypotheses;
  switch (stage_) {
    case Stage::kReduce:
      return 0.15 * row_ / std::max(1, picture_.height);
    case Stage::kFlatten:
    case Stage::kLevels:
      return 0.2;
    case Stage::kVote:
      return 0.2 + 0.35 * votes;
    case Stage::kAlign:
      return 0.55 + 0.25 * std::min(1.0, aligned);
    case Stage::kSmallestCell:
    case Stage::kLargerCell:
      return 0.85;
    case Stage::kMeasure:
      return 0.9;
    case Stage::kDone:
      break;
  }
  return 1;
}

void LatticeSearch::reduce() {
  if (std::min(picture_.width, picture_.height) < 32) {
    error_ = Error{Failure::kPicture,
                   "the picture is too small to see a print: it needs 32 pixels each way at least",
                   -1, -1, "small"};
    stage_ = Stage::kDone;
    return;
  }
  const int to = std::min(picture_.height, row_ + kRowsAtOnce);
  reduceRows(pixels_, factor_, row_, to, picture_);
  row_ = to;
  if (row_ == picture_.height) stage_ = Stage::kFlatten;
}

void LatticeSearch::addLevel() {
  levels_.push_back(ChannelImage::of(picture_));
  if (std::max(picture_.width, picture_.height) >= kSmallestLevel) {
    picture_ = halved(picture_);
    return;
  }
  picture_ = {};
  if (given_) {
    LatticeHypothesis given;
    given.view = TiltedLattice::of(*given_);
    aligned_.push_back(given);
    if (use_ == GivenLattice::kAlign) beginFit(aligned_.front().view, kAlignStages);
    stage_ = Stage::kMeasure;
    return;
  }
  votes_.emplace(levels_);
  part_end_ = TiltVotes::kUsual;
  stage_ = Stage::kVote;
}

void LatticeSearch::vote() {
  votes_->vote(part_);
  if (++part_ < part_end_) return;
  hypotheses_ = votes_->ranked();
  hypothesis_ = 0;
  stage_ = Stage::kAlign;
}

void LatticeSearch::beginFit(const TiltedLattice& start, std::span<const FitStage> stages) {
  fit_.emplace(levels_, start, stages);
}

void LatticeSearch::align() {
  if (fit_) {
    if (fit_->advance()) return;
    keepAligned(fit_->result(), {});
    fit_.reset();
    ++hypothesis_;
    return;
  }
  if (covered_fit_) {
    if (covered_fit_->advance()) return;
    keepAligned(covered_fit_->result(), covered_fit_->hidden());
    covered_fit_.reset();
    ++hypothesis_;
    return;
  }
  const bool is_beside = part_end_ == TiltVotes::kBeside;
  const std::size_t most = is_beside ? kBesideHypotheses : kHypotheses;
  if (hypothesis_ < std::min(most, hypotheses_.size()) &&
      !(is_beside && hypotheses_[hypothesis_].score < kLeastScore)) {
    const TiltedLattice& view = hypotheses_[hypothesis_].view;
    if (is_beside) {
      covered_fit_.emplace(levels_, view);
    } else {
      beginFit(view, kAlignStages);
    }
    return;
  }
  chooseBest();
}

Agreement LatticeSearch::agreement(const TiltedLattice& view) const {
  return agreementOf(sampleCopies(levelFor(levels_, view, kAgreementSamples), view,
                                  visibleCells(view, kAgreementReach), kAgreementSamples, false));
}

void LatticeSearch::keepAligned(const FittedLattice& fitted, const HiddenPlaces& hidden) {
  LatticeHypothesis aligned = hypotheses_[hypothesis_];
  const double change = areaOf(fitted.view) / areaOf(aligned.view);
  if (!(change < kMostChange && change > 1 / kMostChange)) return;
  aligned.view = fitted.view;
  aligned.uncertainty = fitted.uncertainty;
  aligned.hidden = hidden;
  if (hidden.share > 0) {
    aligned.view.focus = hidden.free_middle - aligned.view.middle;
    hide(levels_, &aligned.hidden);
  }
  aligned.explained = agreement(aligned.view).explained;
  aligned.repeated = std::clamp((repeatsOf(aligned) - 1) / (kLeastRepeats - 1), 0.0, 1.0);
  hide(levels_, nullptr);
  if (hidden.share > kMostHidden) {
    shows_two_prints_ |= aligned.explained > kSure && hidden.share < 1 - kLeastOfTwo;
    return;
  }
  aligned_.push_back(aligned);
}

void LatticeSearch::chooseBest() {
  sortBy(aligned_, [](const LatticeHypothesis& aligned) { return -meritOf(aligned); });
  const double merit = aligned_.empty() ? 0 : meritOf(aligned_.front());
  if (part_end_ == TiltVotes::kUsual ? merit < kSure
                                     : merit < kWellExplained && part_end_ < votes_->count()) {
    part_end_ = part_end_ == TiltVotes::kUsual ? TiltVotes::kBeside : votes_->count();
    stage_ = Stage::kVote;
    return;
  }
  if (aligned_.empty() || aligned_.front().explained < kNothing) {
    finish();
    return;
  }
  std::size_t best = 0;
  for (std::size_t i = 1; i < aligned_.size(); ++i) {
    const bool is_as_good = meritOf(aligned_[i]) > meritOf(aligned_.front()) - kAsGood;
    if (is_as_good && areaOf(aligned_[i].view) < 0.9 * areaOf(aligned_[best].view)) best = i;
  }
  std::swap(aligned_.front(), aligned_[best]);
  if (aligned_.front().hidden.share > 0) hide(levels_, &aligned_.front().hidden);
  beginFit(aligned_.front().view, kCellStages);
  stage_ = Stage::kSmallestCell;
}

void LatticeSearch::findSmallestCell() {
  if (fit_ && fit_->advance()) return;
  LatticeHypothesis& best = aligned_.front();
  best.view = fit_->result().view;
  const Copies copies =
      sampleCopies(levelFor(levels_, best.view, kAgreementSamples), best.view,
                   visibleCells(best.view, kAgreementReach), kAgreementSamples, false);
  best.is_stripes = false;
  if (const auto stripes = asStripes(copies, best.view)) {
    best.is_stripes = true;
    best.view = *stripes;
  }
  const CellChoice smallest = withSmallestCell(levels_, {best.view, best.is_stripes});
  best.view = smallest.view;
  stage_ = Stage::kLargerCell;
}

/// An object on the fabric makes copies differ, too, but a larger cell does not explain it.
void LatticeSearch::findLargerCell() {
  LatticeHypothesis& best = aligned_.front();
  const CellChoice own{best.view, best.is_stripes};
  const auto hiddenBy = [&](const TiltedLattice& view) {
    hide(levels_, nullptr);
    HiddenPlaces hidden = hiddenPlaces(levelFor(levels_, view, kAgreementSamples), view, kReach);
    if (hidden.share > kMostHidden) hidden = {};
    return hidden;
  };
  const auto isTaken = [&](const CellChoice& larger, double hidden) {
    const bool is_same = std::abs(areaOf(larger.view) / areaOf(own.view) - 1) < 0.1;
    if (is_same) return false;
    if (hidden == 0) return true;
    const HiddenPlaces left = hiddenBy(larger.view);
    return repeatsSeen(larger.view).minCoeff() >= kLeastRepeats && left.share < kMostLeft * hidden;
  };
  const HiddenPlaces hidden = hiddenBy(best.view);
  const CellChoice larger = withLargerCell(levels_, own);
  if (isTaken(larger, hidden.share)) {
    best.view = larger.view;
    best.hidden = hidden.share > 0 ? hiddenBy(best.view) : hidden;
  } else {
    best.hidden = hidden;
  }
  if (best.hidden.share > 0) {
    best.view.focus = best.hidden.free_middle - best.view.middle;
    hide(levels_, &best.hidden);
  }
  beginFit(best.view, kLastStages);
  stage_ = Stage::kMeasure;
}

void LatticeSearch::measure() {
  if (fit_ && fit_->advance()) return;
  LatticeHypothesis& best = aligned_.front();
  if (fit_) {
    const double change = areaOf(fit_->result().view) / areaOf(best.view);
    if (change < kMostChange && change > 1 / kMostChange) {
      best.view = fit_->result().view;
      best.uncertainty = fit_->result().uncertainty;
    }
  }
  best.explained = agreement(best.view).explained;
  finish();
}

double LatticeSearch::repeatsOf(const LatticeHypothesis& aligned) const {
  const Vec2 seen = repeatsSeen(aligned.view);
  return aligned.is_stripes ? seen.x() : seen.minCoeff();
}

void LatticeSearch::finish() {
  stage_ = Stage::kDone;
  for (const LatticeHypothesis& aligned : aligned_) {
    if (candidates_.size() == kCandidates || aligned.explained < kNothing) continue;
    const bool is_new =
        std::none_of(candidates_.begin(), candidates_.end(), [&](const auto& other) {
          return isSameLattice(TiltedLattice::of(other.map), aligned.view, kSameCandidate);
        });
    if (is_new) candidates_.push_back(readingOf(aligned));
  }
  if (given_) {
    result_ = readingOf(aligned_.front());
    return;
  }
  if (candidates_.empty() || aligned_.front().explained < kNothing) {
    candidates_.clear();
    error_ = shows_two_prints_ ? twoPrints() : whyNoRepeat(levels_, votes_->bestOfMiddle());
    return;
  }
  const LatticeHypothesis& best = aligned_.front();
  const Copies copies =
      sampleCopies(levelFor(levels_, best.view, kAgreementSamples), best.view,
                   visibleCells(best.view, kAgreementReach), kAgreementSamples, false);
  error_ = whyRefused(agreementOf(copies), CopyDifferences(copies), repeatsOf(best));
  if (error_) return;
  result_ = candidates_.front();
  if (mayBeMuchSmaller(best)) result_.confidence = Confidence::kUncertain;
}

bool LatticeSearch::mayBeMuchSmaller(const LatticeHypothesis& best) const {
  return !best.is_stripes && std::any_of(aligned_.begin(), aligned_.end(), [&](const auto& other) {
    return areaOf(other.view) * kMuchLarger < areaOf(best.view) &&
           other.explained > best.explained - kLittleMore;
  });
}

LatticeReading LatticeSearch::readingOf(const LatticeHypothesis& aligned) const {
  TiltedLattice view = aligned.view;
  if (!given_) {
    if (!aligned.is_stripes) {
      const auto reduced = lagrangeReduced(view.basis.col(0), view.basis.col(1));
      view.basis.col(0) = reduced[0];
      view.basis.col(1) = reduced[1];
    }
    // The basis is counter-clockwise in view, where y points down.
    if (view.basis.determinant() > 0) view.basis.col(1) *= -1;
  }
  LatticeReading reading;
  reading.map = view.map();
  reading.explained = aligned.explained;
  reading.copies = wholeCells(view);
  reading.uncertainty = kCreasesAlike * (aligned.is_stripes ? aligned.uncertainty.x()
                                                            : aligned.uncertainty.maxCoeff());
  reading.confidence = aligned.explained >= kSure     ? Confidence::kSure
                       : aligned.explained >= kLikely ? Confidence::kLikely
                                                      : Confidence::kUncertain;
  reading.is_stripes = aligned.is_stripes;
  return reading;
}

}  // namespace seamwise
