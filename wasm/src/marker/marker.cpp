#include "marker/marker.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "base/sort_by.h"
#include "tuning/marker.h"

namespace seamwise {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Share of the layout budget that all variants use before a proof is tried.
constexpr double kFirstShare = 0.3;
constexpr std::size_t kSecondRound = 2;  ///< number of variants that get the rest

double lengthOf(const LayoutSearch& search) {
  return search.best() ? search.best()->length() : std::numeric_limits<double>::infinity();
}

}  // namespace

Marker::Marker(MarkerProblem problem)
    : problem_(std::move(problem)), pieces_(problem_, problem_.ignores_print) {}

LayFabric Marker::fabricOf(double width, double phase) const {
  LayFabric fabric;
  fabric.left = problem_.selvedge;
  fabric.right = width - problem_.selvedge;
  fabric.is_fixed = problem_.start.has_value();
  fabric.origin = {problem_.ignores_print ? fabric.left : phase, problem_.start.value_or(0)};
  return fabric;
}

/// Combinations of garments that point down if all pieces of a garment point the same way.
std::vector<std::vector<int>> Marker::naps() const {
  if (problem_.nap != Nap::kGarment) return {{}};
  int garments = 0;
  for (const MarkerPiece& piece : problem_.pieces) garments = std::max(garments, piece.garment + 1);
  constexpr int kAll = 3;  // if there are more garments, every second one points as the first
  const int free = garments <= kAll ? garments : 2;
  std::vector<std::vector<int>> naps;
  for (int bits = 0; bits < 1 << free; ++bits) {
    std::vector<int> down(garments);
    for (int g = 0; g < garments; ++g) down[g] = bits >> g % free & 1;
    naps.push_back(down);
  }
  return naps;
}

void Marker::makeVariants() {
  for (std::size_t phase = 0; phase < problem_.phases.size(); ++phase) {
    for (const std::vector<int>& nap : naps()) {
      LayFabric fabric = fabricOf(problem_.width, problem_.phases[phase]);
      fabric.turned_down = nap;
      variants_.push_back(
          {phase, std::make_unique<LayoutSearch>(pieces_, fabric, problem_.seed), false});
    }
  }
}

double Marker::budget() const { return MarkerTuning::kLayReads * problem_.effort; }

double Marker::spent() const {
  double reads = 0;
  for (const Variant& variant : variants_) reads += variant.search->reads();
  return reads;
}

double Marker::roundedUp(double length) const {
  if (!problem_.whole_repeats || !pieces_.period()) return length;
  return *pieces_.period() * std::ceil(length / *pieces_.period() - 1e-6);
}

void Marker::keepBest() {
  for (const Variant& variant : variants_) {
    const auto& found = variant.search->best();
    if (!found || (best_ && found->length() > best_->length() - 1e-9)) continue;
    best_ = found;
    best_search_ = variant.search.get();
    const LayFabric& fabric = best_search_->fabric();
    const Vec2 down(0, best_->bottom);
    origin_ = fabric.origin - down;
    places_.clear();
    for (std::size_t k = 0; k < best_->places.size(); ++k) {
      const LayPlace& place = best_->places[k];
      places_.push_back(pieces_.place(static_cast<int>(k), place.way, place.dot, origin_));
    }
    ++count_;
  }
}

bool Marker::goOn(LayoutSearch& search, double most) {
  const double before = search.reads();
  const bool more = search.construct() || (search.reads() < most && search.improve());
  reads_ += search.reads() - before + 1;
  return more;
}

/// Makes one step of the next variant. All variants have a share of the budget, then the best ones
/// get the rest.
void Marker::lay() {
  if (spent() < kFirstShare * budget() || !best_) {
    const double share = kFirstShare * budget() / static_cast<double>(variants_.size());
    for (std::size_t tried = 0; tried < variants_.size(); ++tried) {
      Variant& variant = variants_[turn_++ % variants_.size()];
      if (variant.is_done) continue;
      variant.is_done = !goOn(*variant.search, share);
      return keepBest();
    }
  }
  if (!best_) return fail();
  // A single variant may be proven soon. The best of several is unknown before this search.
  if ((proofs_ > 0 || variants_.size() > 1) && spent() < budget()) {
    sortBy(variants_, [](const Variant& variant) { return lengthOf(*variant.search); });
    for (std::size_t k = 0; k < std::min(kSecondRound, variants_.size()); ++k) {
      LayoutSearch& search = *variants_[turn_++ % std::min(kSecondRound, variants_.size())].search;
      const double before = search.reads();
      const bool more = search.improve();
      reads_ += search.reads() - before + 1;
      keepBest();
      if (more) return;
    }
    is_searched_ = true;
  }
  beginProof();
}

void Marker::makeTables() {
  const double dots = pieces_.makeTable();
  reads_ += MarkerTuning::kReadsOfTable + MarkerTuning::kReadsOfDot * dots;
  if (dots > 0) return;
  makeVariants();
  stage_ = Stage::kLay;
}

bool Marker::advance(double work) {
  reads_ = 0;
  while (reads_ < work * 1e6 && stage_ != Stage::kDone) {
    switch (stage_) {
      case Stage::kTables:
        makeTables();
        break;
      case Stage::kLay:
        lay();
        break;
      case Stage::kProve:
        prove();
        break;
      case Stage::kFree:
        layFree();
        break;
      case Stage::kWidths:
        layWidths();
        break;
      case Stage::kDone:
        break;
    }
  }
  return stage_ != Stage::kDone;
}

double Marker::fraction() const {
  const auto share = [](double done, double all) {
    return all > 0 ? std::min(1.0, done / all) : 1.0;
  };
  switch (stage_) {
    case Stage::kTables:
      return 0.1 * pieces_.made();
    case Stage::kLay:
      return 0.1 + 0.3 * share(spent(), budget());
    case Stage::kProve:
      return 0.4 + 0.2 * (proof_ ? share(proof_->reads(), proof_work_) : 0);
    case Stage::kFree:
      return 0.6 + 0.3 * (free_search_ ? share(free_search_->reads(), budget()) : 0);
    case Stage::kWidths:
      return 0.9 +
             0.1 * share(static_cast<double>(width_), static_cast<double>(problem_.widths.size()));
    case Stage::kDone:
      return 1;
  }
  return 1;
}

std::vector<double> Marker::phaseLengths() const {
  std::vector<double> lengths(problem_.phases.size(), kNaN);
  for (const Variant& variant : variants_) {
    const auto& found = variant.search->best();
    double& length = lengths[variant.phase];
    if (found && !(length <= roundedUp(found->length()))) length = roundedUp(found->length());
  }
  return lengths;
}

std::vector<RigidMotion> Marker::freePlaces(int piece) const {
  std::vector<RigidMotion> places;
  const LayFabric& fabric = best_search_->fabric();
  const double more = pieces_.period().value_or(50);
  const Window window{fabric.left, fabric.right, best_->bottom, best_->top + more};
  const LayItem& item = pieces_.items()[piece];
  const std::vector<int> ways = allowedWays(pieces_, fabric)[piece];
  for (const int way : ways) {
    const int placed = item.ways[way].placed;
    const auto flaws = pieces_.flawTables(placed, fabric.origin);
    const Domain domain = pieces_.domain(placed, window, fabric.origin);
    for (int j = domain.first; j <= domain.rows().hi; ++j) {
      for (int i = domain.row(j).lo; i <= domain.row(j).hi; ++i) {
        const Dot dot{i, j};
        const auto overlaps = [&](std::size_t other) {
          if (other == static_cast<std::size_t>(piece)) return false;
          const LayPlace& there = best_->places[other];
          const int theirs = pieces_.items()[other].ways[there.way].placed;
          return pieces_.table(theirs, placed).depth(dot - there.dot) > 0;
        };
        bool is_free = true;
        for (std::size_t other = 0; other < best_->places.size() && is_free; ++other)
          is_free = !overlaps(other);
        for (const DifferenceTable& flaw : flaws) is_free = is_free && flaw.depth(dot) == 0;
        if (is_free) places.push_back(pieces_.place(piece, way, dot, origin_));
      }
    }
  }
  return places;
}

}  // namespace seamwise
