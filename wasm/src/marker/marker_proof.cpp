#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>

#include "marker/marker.h"
#include "tuning/marker.h"

namespace seamwise {
namespace {

/// Shares of the proof budget: for a proof that no layout is shorter than the best, and for others.
constexpr double kProofOfBest = 0.5, kOtherProof = 0.1;
constexpr int kMostProofs = 6;
constexpr double kWorthProving = 0.5;  ///< least difference of bound and best, cm
constexpr double kLessLength = 0.01;   ///< cm

}  // namespace

/// The fabric of the best layout, but with free directions of garments.
LayFabric Marker::fabricOfProof() const {
  LayFabric fabric = best_search_->fabric();
  fabric.is_by_garment = problem_.nap == Nap::kGarment;
  fabric.turned_down.clear();
  return fabric;
}

void Marker::beginProof() {
  stage_ = Stage::kDone;
  if (problem_.effort == 0) return;
  const LayFabric fabric = fabricOfProof();
  double tallest = 0;
  const auto ways = allowedWays(pieces_, fabric);
  for (std::size_t k = 0; k < ways.size(); ++k) {
    double least = std::numeric_limits<double>::infinity();
    for (const int way : ways[k]) {
      const Shape& shape = pieces_.shapeOf(pieces_.items()[k].ways[way]);
      least = std::min(least, shape.high.y() - shape.low.y());
    }
    tallest = std::max(tallest, least);
  }
  const double area = pieces_.area() / (fabric.right - fabric.left);
  bound_ = std::min(best_->length(), std::max({bound_, tallest, area}));
  is_proven_ = bound() >= length() - kLessLength;
  stage_ = is_proven_ ? Stage::kFree : Stage::kProve;
}

/// Starts the next proof if it is worth the work. The first one is that no layout is shorter than
/// the best, unless that has failed for this length. The others are that none is shorter than the
/// mean of bound and best.
bool Marker::beginNextProof() {
  const double all = MarkerTuning::kProofRows * problem_.effort;
  const bool is_first = proofs_ == 0 || best_->length() < tried_length_ - kLessLength;
  const bool is_worth = proofs_ < kMostProofs && best_->length() - bound_ > kWorthProving;
  if (!is_first && !is_worth) return false;
  is_of_best_ = is_first;
  if (is_first) tried_length_ = best_->length();
  const double shortest = problem_.whole_repeats && pieces_.period()
                              ? length() - *pieces_.period()
                              : best_->length() - kLessLength;
  proof_target_ = is_first ? shortest : (bound_ + best_->length()) / 2;
  proof_work_ = (is_first ? kProofOfBest : kOtherProof) * all;
  proof_ = std::make_unique<CompleteSearch>(pieces_, fabricOfProof(), proof_target_);
  ++proofs_;
  return proof_->canProve();
}

/// Adopts a shorter layout as the best; the variant with its garment directions continues from it.
void Marker::take(const LaidPieces& found) {
  LayFabric fabric = best_search_->fabric();
  for (std::size_t k = 0; k < found.places.size() && !fabric.turned_down.empty(); ++k) {
    const LayItem& item = pieces_.items()[k];
    fabric.turned_down[item.garment] = item.ways[found.places[k].way].is_up ? 0 : 1;
  }
  const auto variantOf = [&](auto is_it) {
    return std::find_if(variants_.begin(), variants_.end(), is_it);
  };
  auto variant = variantOf([&](const Variant& other) {
    const LayFabric& its = other.search->fabric();
    return its.origin == fabric.origin && its.turned_down == fabric.turned_down;
  });
  if (variant == variants_.end()) {
    const auto best =
        variantOf([&](const Variant& other) { return other.search.get() == best_search_; });
    variants_.push_back(
        {best->phase, std::make_unique<LayoutSearch>(pieces_, fabric, problem_.seed), false});
    variant = variants_.end() - 1;
  }
  variant->search->offer(found);
  keepBest();
}

void Marker::prove() {
  if (!proof_ && !beginNextProof()) {
    proof_.reset();
    stage_ = spent() < budget() && !is_searched_ ? Stage::kLay : Stage::kFree;
    return;
  }
  constexpr double kStep = 1e5;
  const double before = proof_->reads();
  const bool more = proof_->step(kStep);
  reads_ += MarkerTuning::kReadsOfRow * (proof_->reads() - before) + 1;
  if (more && proof_->reads() < proof_work_) return;
  const bool is_open = more;
  if (const auto& found = proof_->found()) {
    take(*found);
    is_searched_ = false;
    if (is_of_best_) --proofs_;  // restarts the proof with the shorter layout
  } else if (!is_open) {
    bound_ = std::max(bound_, is_of_best_ ? best_->length() : proof_target_);
    is_proven_ = is_of_best_;
  }
  proof_.reset();
  if (is_proven_)
    stage_ = Stage::kFree;
  else if (is_of_best_ && is_open && spent() < budget() && !is_searched_)
    stage_ = Stage::kLay;  // there may be a shorter layout
}

}  // namespace seamwise
