#include "recognition/lattice_search.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "recognition/cell_tests.h"
#include "recognition/channels.h"
#include "recognition/lattice_vote.h"
#include "recognition/stripes.h"
#include "wallpaper/lattice.h"

namespace seamwise {
namespace {
const bool dbg = getenv("LDBG") != nullptr;
constexpr int kLongest = 1280;
constexpr int kVoteLongest = 300;
constexpr double kLightSigma = 0.16;
constexpr double kShortest = 6;

std::vector<TiltedPart> parts() {
  std::vector<TiltedPart> list{{Vec2::Zero(), 1}, {Vec2::Zero(), 0.5}, {Vec2::Zero(), 0.25}};
  for (int k = 0; k < 6; ++k) list.push_back({0.13 * unit(kPi * k / 3), 1});
  for (int k = 0; k < 12; ++k) list.push_back({0.25 * unit(kPi * (k + 0.5) / 6), 1});
  for (int k = 0; k < 14; ++k) list.push_back({0.36 * unit(2 * kPi * k / 14), 1});
  return list;
}
}  // namespace

LatticeSearch::LatticeSearch(const PixelView& view) : view_(view) {
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
      flatten(picture_, kLightSigma * std::min(picture_.width, picture_.height));
      stage_ = Stage::kLevels;
      break;
    case Stage::kLevels:
      addLevels();
      break;
    case Stage::kVote:
      vote();
      break;
    case Stage::kAlign:
      align();
      break;
    case Stage::kCells:
      testCells();
      break;
    case Stage::kMeasure:
      measure();
      break;
    case Stage::kDone:
      return false;
  }
  return stage_ != Stage::kDone;
}

void LatticeSearch::reduce() {
  const int to = std::min(picture_.height, row_ + 64);
  reduceRows(view_, factor_, row_, to, picture_);
  row_ = to;
  if (row_ == picture_.height) stage_ = Stage::kFlatten;
}

void LatticeSearch::addLevels() {
  levels_.push_back(ChannelImage::of(picture_));
  if (std::max(picture_.width, picture_.height) >= 150) {
    picture_ = halved(picture_);
    return;
  }
  stage_ = Stage::kVote;
  part_end_ = 9;
  std::size_t l = 0;
  while (std::max(levels_[l].width, levels_[l].height) > kVoteLongest) ++l;
  axes_ = principalAxes(levels_[l]);
}

void LatticeSearch::vote() {
  const TiltedPart part = parts()[part_];
  std::size_t l = 0;
  while (l + 1 < levels_.size() &&
         part.share * std::max(levels_[l].width, levels_[l].height) > kVoteLongest)
    ++l;
  const ChannelImage& image = levels_[l];
  const WeightedPlanes planes = tiltedPlanes(image, axes_, part);
  const int reach_x = static_cast<int>(0.55 * part.share * image.width),
            reach_y = static_cast<int>(0.55 * part.share * image.height);
  const Autocorrelation r = autocorrelation(planes, reach_x, reach_y, 0.04);
  std::vector<VotedLattice> voted = voteStripes(r, kShortest);
  for (const auto& v : voteLattices(r, kShortest, 3)) voted.push_back(v);
  const double unit_px = std::max(image.width, image.height) / 2.0;
  for (const auto& v : voted) {
    Hypothesis h;
    h.view.middle = Vec2(picture_.width, picture_.height) * 0;
    h.view.middle = Vec2(view_.width, view_.height) / 2;
    h.view.radius = std::max(view_.width, view_.height) / 2.0;
    h.view.basis << v.basis[0], v.basis[1];
    h.view.basis /= unit_px;
    h.view.tilt = part.tilt;
    h.score = v.score;
    h.is_stripes = v.is_stripes;
    if (dbg)
      fprintf(stderr,
              "vote part %zu share %.2f tilt %.2f %.2f: score %.3f stripes %d basis %.3f %.3f | "
              "%.3f %.3f\n",
              part_, part.share, part.tilt.x(), part.tilt.y(), h.score, h.is_stripes,
              h.view.basis(0, 0), h.view.basis(1, 0), h.view.basis(0, 1), h.view.basis(1, 1));
    addHypothesis(h);
  }
  if (++part_ == part_end_) beginAlignment();
}

void LatticeSearch::addHypothesis(Hypothesis h) {
  for (auto& other : hypotheses_) {
    const Mat2 index = other.view.basis.inverse() * h.view.basis;
    const Mat2 whole = index.array().round();
    if (std::abs(std::abs(whole.determinant()) - 1) < 1e-9 && (index - whole).norm() < 0.08) {
      if (h.score > other.score) other = h;
      return;
    }
  }
  hypotheses_.push_back(h);
}

void LatticeSearch::beginAlignment() {
  std::stable_sort(hypotheses_.begin(), hypotheses_.end(),
                   [](const auto& a, const auto& b) { return a.score > b.score; });
  stage_ = Stage::kAlign;
  next_ = 0;
}

void LatticeSearch::align() {
  if (next_ < std::min<std::size_t>(6, hypotheses_.size())) {
    Hypothesis h = hypotheses_[next_++];
    const double before = std::abs(h.view.basis.determinant());
    for (const FitStage& s :
         {FitStage{1.5, 16, FitUnknowns::kBasis, 6}, FitStage{2.5, 16, FitUnknowns::kTilt, 6},
          FitStage{20, 16, FitUnknowns::kTilt, 8}}) {
      const FittedLattice f = fitLattice(levels_, h.view, s);
      h.view = f.view;
      h.uncertainty = f.uncertainty;
    }
    const CellList cells = visibleCells(h.view, 1);
    if (cells.empty()) return;
    const int n = 20;
    const Agreement a = agreementOf(
        sampleCopies(levelFor(levels_, h.view, n), h.view, visibleCells(h.view, 6), n, false));
    h.explained = a.explained;
    const double after = std::abs(h.view.basis.determinant());
    if (dbg)
      fprintf(stderr, "align score %.3f -> explained %.3f area ratio %.3f tilt %.3f %.3f\n",
              h.score, h.explained, after / before, h.view.tilt.x(), h.view.tilt.y());
    if (after / before < 0.6 || after / before > 1.6) return;
    aligned_.push_back(h);
    return;
  }
  if (aligned_.empty()) {
    stage_ = Stage::kMeasure;
    return;
  }
  std::stable_sort(aligned_.begin(), aligned_.end(),
                   [](const auto& a, const auto& b) { return a.explained > b.explained; });
  if (aligned_[0].explained < 0.6 && part_end_ < parts().size()) {
    part_end_ = parts().size();
    stage_ = Stage::kVote;
    hypotheses_.clear();
    return;
  }
  // the smallest among the good
  std::size_t best = 0;
  for (std::size_t i = 1; i < aligned_.size(); ++i)
    if (aligned_[i].explained > aligned_[0].explained - 0.04 &&
        std::abs(aligned_[i].view.basis.determinant()) <
            0.9 * std::abs(aligned_[best].view.basis.determinant()))
      best = i;
  std::swap(aligned_[0], aligned_[best]);
  stage_ = Stage::kCells;
}

// A smaller cell that no larger one is needed beside.
void LatticeSearch::testCells() {
  Hypothesis& h = aligned_[0];
  h.view = fitLattice(levels_, h.view, FitStage{20, 24, FitUnknowns::kLens, 4}).view;
  const auto copiesOf = [&](const TiltedLattice& view, int n) {
    return sampleCopies(levelFor(levels_, view, n), view, visibleCells(view, 5), n, false);
  };
  const auto trial = [&](const SplitEvidence& e, int index, const Mat2& m, const char* what) {
    if (dbg && e.ratio > 0)
      fprintf(stderr, "%s %d (%g %g %g): ratio %.2f share %.4f worst %.3f within %.5f %s\n", what,
              index, m(0, 0), m(0, 1), m(1, 1), e.ratio, e.share, e.worst, e.within,
              isSplit(e) ? "SPLIT" : "");
  };
  if (const auto stripes = asStripes(copiesOf(h.view, 24), h.view)) {
    h.is_stripes = true;
    h.view = fitLattice(levels_, *stripes, FitStage{20, 24, FitUnknowns::kTilt, 6}).view;
    if (dbg) fprintf(stderr, "stripes\n");
  }
  double explained = agreementOf(copiesOf(h.view, 16)).explained;
  bool is_smaller = true;
  for (int round = 0; is_smaller && round < 5; ++round) {
    is_smaller = false;
    for (int index = 2; index <= 3 && !is_smaller; ++index)
      for (const Mat2& m : largerCells(index)) {
        if (h.is_stripes && m(1, 1) != 1) continue;
        const TiltedLattice finer = h.view.rebased(m.inverse().transpose());
        const auto reduced = lagrangeReduced(finer.basis.col(0), finer.basis.col(1));
        if (reduced[0].norm() * h.view.radius * levels_[0].scale < kShortest ||
            (!h.is_stripes && reduced[0].norm() < 0.15 * reduced[1].norm()))
          continue;
        const Copies copies = copiesOf(finer, 16);
        const double e = agreementOf(copies).explained;
        if (e < explained - 0.15) continue;
        const SplitEvidence split =
            splitEvidence(CopyDifferences(copies), Mat2::Identity(), m.transpose(), finer.basis);
        trial(split, index, m, "finer");
        if (isSplit(split)) continue;
        explained = e;
        h.view = finer;
        is_smaller = true;
        break;
      }
  }
  const CopyDifferences differences(copiesOf(h.view, 24));
  Mat2 lattice = Mat2::Identity();
  for (int round = 0; round < 3; ++round) {
    Mat2 best = Mat2::Identity();
    double best_w = 1e300;
    for (int index = 2; index <= 6; ++index)
      for (const Mat2& m : largerCells(index)) {
        if (h.is_stripes && m(1, 1) != 1) continue;
        const SplitEvidence e = splitEvidence(differences, lattice, m, h.view.basis);
        trial(e, index, m, "larger");
        if (isSplit(e) && e.within < 0.8 * best_w) {
          best_w = e.within;
          best = m;
        }
      }
    if (best == Mat2::Identity()) break;
    lattice = lattice * best;
  }
  h.view = h.view.rebased(lattice);
  stage_ = Stage::kMeasure;
}

void LatticeSearch::measure() {
  if (!aligned_.empty()) {
    Hypothesis& h = aligned_[0];
    for (const FitStage& s :
         {FitStage{20, 32, FitUnknowns::kLens, 6}, FitStage{20, 48, FitUnknowns::kLens, 4}}) {
      const FittedLattice f = fitLattice(levels_, h.view, s);
      h.view = f.view;
      h.uncertainty = f.uncertainty;
      if (dbg)
        fprintf(stderr, "measure converged %d tilt %.4f %.4f lens %.4f\n", f.has_converged,
                h.view.tilt.x(), h.view.tilt.y(), h.view.lens);
    }
    const Agreement a = agreementOf(
        sampleCopies(levelFor(levels_, h.view, 32), h.view, visibleCells(h.view, 12), 32, false));
    h.explained = a.explained;
    if (dbg) {
      double bad = 0, good = 0, all = 0;
      for (size_t i = 0; i < a.of_cells.size(); ++i) {
        all += a.cell_share[i];
        (a.of_cells[i] < 0.25 ? bad : good) += a.cell_share[i];
      }
      const Vec2 rep = repeatsSeen(h.view);
      fprintf(stderr, "verdict explained %.3f badcells %.2f repeats %.2f %.2f variance %.5f\n",
              a.explained, bad / all, rep.x(), rep.y(), a.variance);
    }
  }
  if (dbg)
    for (auto& l : levels_) {
      double v = 0;
      for (float x : l.samples) v += x * x;
      fprintf(stderr, "level %d variance %.6f\n", l.width, v / l.width / l.height);
    }
  finish();
}
void LatticeSearch::finish() {
  stage_ = Stage::kDone;
  for (auto& h : aligned_)
    if (candidates_.size() < 3) candidates_.push_back(readingOf(h));
  const char* none =
      "no repeat was found on the picture: photograph the cloth flat and from above, so that at "
      "least three repeats are seen";
  if (aligned_.empty() || aligned_[0].explained < 0.3) {
    result_ = Error{Failure::kPicture, none};
    return;
  }
  const Vec2 seen = repeatsSeen(aligned_[0].view);
  if ((aligned_[0].is_stripes ? seen.x() : seen.minCoeff()) < 2.2) {
    result_ = Error{Failure::kPicture,
                    "fewer than 2.2 repeats are seen: step back until three repeats are seen"};
    return;
  }
  result_ = candidates_[0];
}
LatticeReading LatticeSearch::readingOf(const Hypothesis& h) const {
  LatticeReading reading;
  TiltedLattice view = h.view;
  const auto reduced = lagrangeReduced(view.basis.col(0), view.basis.col(1));
  if (!h.is_stripes) view.basis << reduced[0], reduced[1];
  if (view.basis.determinant() > 0) view.basis.col(1) *= -1;
  reading.map = view.map();
  reading.explained = h.explained;
  reading.uncertainty = h.is_stripes ? h.uncertainty.x() : h.uncertainty.maxCoeff();
  reading.confidence = h.explained > 0.75  ? Confidence::kSure
                       : h.explained > 0.6 ? Confidence::kLikely
                                           : Confidence::kUncertain;
  reading.is_stripes = h.is_stripes;
  const Copies copies = sampleCopies(levels_.back(), view, visibleCells(view, 30), 4, false);
  for (std::size_t c = 0; c < copies.cells.size(); ++c) {
    bool is_whole = true;
    for (std::size_t s = 0; s < 16; ++s) is_whole = is_whole && copies.weights[16 * c + s] > 0;
    reading.copies += is_whole ? 1 : 0;
  }
  return reading;
}
double LatticeSearch::fraction() const { return 0; }
}  // namespace seamwise
