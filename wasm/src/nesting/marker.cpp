#include "nesting/marker.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "base/decimal.h"
#include "base/sort_by.h"

namespace seamwise {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// Budgets at effort 1, in table reads. Chosen so that each stage takes about half a second of one
// core in WebAssembly for a dozen pieces.
constexpr double kLayReads = 1.5e9;
constexpr double kProofReads = 400e6;
constexpr double kWidthReads = 50e6;
/// Of the budget for laying: what all variants share before a proof is tried.
constexpr double kFirstShare = 0.3;
constexpr std::size_t kSecondRound = 2;  ///< variants that get the rest
/// Of the budget for proofs, what one gets that nothing is shorter than the best, and what others.
constexpr double kProofOfBest = 0.5, kOtherProof = 0.1;
constexpr int kMostProofs = 6;
constexpr double kWorthProving = 0.5;  ///< cm between bound and best
constexpr double kLessLength = 0.01;  ///< cm
constexpr double kReadsOfCell = 20;  ///< to make a table's dot, in reads of one
constexpr double kReadsOfRow = 5;    ///< of a proof
/// How much wider cloth is looked at for a piece that finds no place. [cm]
constexpr double kMostWider = 200, kWider = 0.5;

double lengthOf(const LayoutSearch& search) {
  return search.best() ? search.best()->length() : std::numeric_limits<double>::infinity();
}

std::string centimetres(double length) { return fixed(length, 1) + " cm"; }
/// Rounded up, so that cloth of that width is wide enough.
std::string atLeast(double length) { return centimetres(std::ceil(10 * length - 1e-4) / 10); }

}  // namespace

Outcome<std::unique_ptr<Marker>> Marker::make(NestingProblem problem) {
  if (problem.pieces.empty()) return Error{Failure::kOptions, "There is no piece to lay."};
  const double room = problem.width - 2 * problem.selvedge;
  std::unique_ptr<Marker> marker(new Marker(std::move(problem)));
  for (std::size_t k = 0; k < marker->problem_.pieces.size(); ++k) {
    const NestingPiece& piece = marker->problem_.pieces[k];
    const std::vector<LayWay>& ways = marker->pieces_.items()[k].ways;
    if (ways.empty())
      return Error{Failure::kOptions, piece.name + " cannot lie with its upper end up on this print; "
                                                   "allow both ways."};
    double least = std::numeric_limits<double>::infinity();
    for (const LayWay& way : ways) {
      const Shape& shape = marker->pieces_.shapeOf(way);
      least = std::min(least, shape.high.x() - shape.low.x());
    }
    if (!piece.pin && least > room + 1e-5)
      return Error{Failure::kOptions,
                   piece.name + " is " + atLeast(least) + " wide, more than the " +
                       centimetres(std::max(room, 0.0)) +
                       " between the selvedges; the cloth has to be at least " +
                       atLeast(least + 2 * marker->problem_.selvedge) + " wide."};
  }
  return marker;
}

Marker::Marker(NestingProblem problem)
    : problem_(std::move(problem)), pieces_(problem_, problem_.ignores_print) {}

LayCloth Marker::clothOf(double width, double phase) const {
  LayCloth cloth;
  cloth.left = problem_.selvedge;
  cloth.right = width - problem_.selvedge;
  cloth.is_fixed = problem_.start.has_value();
  cloth.origin = {problem_.ignores_print ? cloth.left : phase, problem_.start.value_or(0)};
  return cloth;
}

/// Which garments may point down, where all pieces of one point the same way.
std::vector<std::vector<bool>> Marker::naps() const {
  if (problem_.nap != Nap::kGarment) return {{}};
  int garments = 0;
  for (const NestingPiece& piece : problem_.pieces) garments = std::max(garments, piece.garment + 1);
  constexpr int kAll = 3;  // of more garments, not all combinations are tried
  std::vector<std::vector<bool>> naps;
  if (garments <= kAll) {
    for (int bits = 0; bits < 1 << garments; ++bits) {
      std::vector<bool> down;
      for (int g = 0; g < garments; ++g) down.push_back((bits >> g & 1) != 0);
      naps.push_back(down);
    }
    return naps;
  }
  for (int odd = 0; odd < 2; ++odd) {
    for (int even = 0; even < 2; ++even) {
      std::vector<bool> down;
      for (int g = 0; g < garments; ++g) down.push_back((g % 2 == 0 ? even : odd) != 0);
      naps.push_back(down);
    }
  }
  return naps;
}

void Marker::makeVariants() {
  for (std::size_t phase = 0; phase < problem_.phases.size(); ++phase) {
    for (const std::vector<bool>& nap : naps()) {
      LayCloth cloth = clothOf(problem_.width, problem_.phases[phase]);
      cloth.turned_down = nap;
      variants_.push_back(
          {phase, std::make_unique<LayoutSearch>(pieces_, cloth, problem_.seed), false});
    }
  }
}

double Marker::budget() const { return kLayReads * problem_.effort; }

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
    const LayCloth& cloth = best_search_->cloth();
    const Vec2 down(0, best_->bottom);
    origin_ = cloth.origin - down;
    places_.clear();
    for (std::size_t k = 0; k < best_->places.size(); ++k) {
      const LayPlace& place = best_->places[k];
      places_.push_back(pieces_.place(static_cast<int>(k), place.way, place.dot, origin_));
    }
    ++count_;
  }
}

/// One step of one variant, in turn: all of them have a share, then the best of them the rest.
void Marker::lay() {
  if (spent() < kFirstShare * budget() || !best_) {
    const double share = kFirstShare * budget() / static_cast<double>(variants_.size());
    for (std::size_t tried = 0; tried < variants_.size(); ++tried) {
      Variant& variant = variants_[turn_++ % variants_.size()];
      if (variant.is_done) continue;
      LayoutSearch& search = *variant.search;
      const double before = search.reads();
      if (!search.construct()) variant.is_done = search.reads() >= share || !search.improve();
      reads_ += search.reads() - before + 1;
      return keepBest();
    }
  }
  if (!best_) return fail();
  if (proofs_ > 0 && spent() < budget()) {
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

void Marker::fail() {
  const LayoutSearch& search = *variants_.front().search;
  const int item = std::max(search.homeless(), 0);
  const NestingPiece& piece = problem_.pieces[item];
  stage_ = Stage::kDone;
  if (piece.pin) {
    error_ = Error{Failure::kOptions, piece.name +
                                          " cannot lie where it is pinned: it overlaps another "
                                          "pinned piece or a flaw, or leaves the cloth; move it."};
    return;
  }
  if (!problem_.flaws.empty()) {
    error_ = Error{Failure::kOptions,
                   piece.name + " finds no place between the flaws of the cloth."};
    return;
  }
  for (double width = problem_.width; width < problem_.width + kMostWider; width += kWider) {
    for (const double phase : problem_.phases) {
      const LayCloth cloth = clothOf(width, phase);
      const Window window{cloth.left, cloth.right, 0, 1000};
      for (const LayWay& way : pieces_.items()[item].ways) {
        const Domain domain = pieces_.domain(way.placed, window, cloth.origin);
        if (std::none_of(domain.runs.begin(), domain.runs.end(),
                         [](const DotRun& run) { return !run.empty(); }))
          continue;
        error_ = Error{Failure::kOptions,
                       "On this repeat " + piece.name + " fits nowhere across " +
                           centimetres(problem_.width) + "; the cloth has to be at least " +
                           atLeast(width) + " wide."};
        return;
      }
    }
  }
  error_ = Error{Failure::kOptions, "On this repeat " + piece.name + " fits nowhere across " +
                                        centimetres(problem_.width) + "."};
}

void Marker::beginProof() {
  stage_ = Stage::kDone;
  if (problem_.effort == 0) return;
  const LayCloth& cloth = best_search_->cloth();
  double tallest = 0;
  const auto ways = allowedWays(pieces_, cloth);
  for (std::size_t k = 0; k < ways.size(); ++k) {
    double least = std::numeric_limits<double>::infinity();
    for (const int way : ways[k]) {
      const Shape& shape = pieces_.shapeOf(pieces_.items()[k].ways[way]);
      least = std::min(least, shape.high.y() - shape.low.y());
    }
    tallest = std::max(tallest, least);
  }
  const double area = pieces_.area() / (cloth.right - cloth.left);
  bound_ = std::min(best_->length(), std::max({bound_, tallest, area}));
  is_proven_ = bound() >= length() - kLessLength;
  stage_ = is_proven_ ? Stage::kFree : Stage::kProve;
}

/// What the next proof is to be of, if one is worth its work: that nothing is shorter than the best,
/// as long as that has not been tried in vain; then, that nothing is shorter than what lies between
/// the bound and the best.
bool Marker::beginNextProof() {
  const double all = kProofReads * problem_.effort;
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
  proof_ = std::make_unique<CompleteSearch>(pieces_, best_search_->cloth(), proof_target_);
  ++proofs_;
  return proof_->canProve();
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
  reads_ += kReadsOfRow * (proof_->reads() - before) + 1;
  if (more && proof_->reads() < proof_work_) return;
  const bool is_open = more;
  if (const auto& found = proof_->found()) {
    for (const Variant& variant : variants_)
      if (variant.search.get() == best_search_) variant.search->offer(*found);
    keepBest();
    is_searched_ = false;
    if (is_of_best_) --proofs_;  // begins anew, below the shorter one
  } else if (!is_open) {
    bound_ = std::max(bound_, is_of_best_ ? best_->length() : proof_target_);
    is_proven_ = is_of_best_;
  }
  proof_.reset();
  if (is_proven_)
    stage_ = Stage::kFree;
  else if (is_of_best_ && is_open && spent() < budget() && !is_searched_)
    stage_ = Stage::kLay;  // there may be something shorter
}

void Marker::layFree() {
  if (!problem_.also_free || problem_.ignores_print) {
    if (problem_.ignores_print) free_length_ = length();
    stage_ = Stage::kWidths;
    return;
  }
  if (!free_pieces_) free_pieces_ = std::make_unique<PiecesOnBoard>(problem_, true);
  if (!free_search_) {
    if (free_pieces_->makeTable()) {
      reads_ += kReadsOfCell * 1e4;
      return;
    }
    LayCloth cloth = clothOf(problem_.width, 0);
    cloth.origin = {cloth.left, 0};
    free_search_ = std::make_unique<LayoutSearch>(*free_pieces_, cloth, problem_.seed);
  }
  const double before = free_search_->reads();
  bool more = free_search_->construct();
  if (!more) more = free_search_->reads() < budget() && free_search_->improve();
  reads_ += free_search_->reads() - before + 1;
  if (more) return;
  // a layout on the print is one without it
  free_length_ = free_search_->best() ? std::min(free_search_->best()->length(), best_->length())
                                      : best_->length();
  stage_ = Stage::kWidths;
}

void Marker::layWidths() {
  if (width_ == problem_.widths.size()) {
    stage_ = Stage::kDone;
    return;
  }
  const double width = problem_.widths[width_];
  if (!width_search_) {
    LayCloth cloth = best_search_->cloth();
    cloth.right = width - problem_.selvedge;
    width_search_ = std::make_unique<LayoutSearch>(pieces_, cloth, problem_.seed);
    // what goes onto narrower cloth goes onto this, too
    if (width >= problem_.width) width_search_->offer(*best_);
  }
  const double before = width_search_->reads();
  bool more = width_search_->construct();
  if (!more && width_search_->best())
    more = width_search_->reads() < kWidthReads * problem_.effort && width_search_->improve();
  reads_ += width_search_->reads() - before + 1;
  if (more) return;
  const auto& found = width_search_->best();
  const bool is_same = std::abs(width - problem_.width) < 1e-9;
  width_lengths_.push_back(is_same ? length() : found ? roundedUp(found->length()) : kNaN);
  width_search_.reset();
  ++width_;
}

bool Marker::advance(double work) {
  reads_ = 0;
  while (reads_ < work * 1e6 && stage_ != Stage::kDone) {
    switch (stage_) {
      case Stage::kTables:
        reads_ += kReadsOfCell * 1e4;
        if (pieces_.makeTable()) break;
        makeVariants();
        stage_ = Stage::kLay;
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
  const auto share = [](double done, double all) { return all > 0 ? std::min(1.0, done / all) : 1.0; };
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
      return 0.9 + 0.1 * share(static_cast<double>(width_), static_cast<double>(problem_.widths.size()));
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
  constexpr std::size_t kMostPlaces = 20000;
  std::vector<RigidMotion> places;
  const LayCloth& cloth = best_search_->cloth();
  const double more = pieces_.period().value_or(50);
  const Window window{cloth.left, cloth.right, best_->bottom, best_->top + more};
  const LayItem& item = pieces_.items()[piece];
  const std::vector<int> ways = allowedWays(pieces_, cloth)[piece];
  for (const int way : ways) {
    const int placed = item.ways[way].placed;
    const auto flaws = pieces_.flawTables(placed, cloth.origin);
    const Domain domain = pieces_.domain(placed, window, cloth.origin);
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
        if (is_free && places.size() < kMostPlaces)
          places.push_back(pieces_.place(piece, way, dot, origin_));
      }
    }
  }
  return places;
}

}  // namespace seamwise
