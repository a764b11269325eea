#include "photo/lattice/tilt_votes.h"

#include <algorithm>
#include <cmath>

#include "base/sort_by.h"
#include "photo/lattice/lattice_vote.h"

namespace seamwise {
namespace {

constexpr int kLongestVotingPart = 330;  // longer side of an autocorrelated part. [pixels]
constexpr double kShortestPixels = 6;    // minimum repeat; the weave is shorter. [pixels]
constexpr double kShiftReach = 0.55;     // maximum shift, in widths and heights of the part
constexpr double kLeastMeeting = 0.04;   // minimum share of weights that overlap at a shift
constexpr double kMiddle = 0.5;          // share of width and height
constexpr double kPartBeside = 0.62;  // share of width and height of parts beside an object; chosen
constexpr int kLatticesOfEach = 3;
constexpr double kSame = 0.06;  // share of w1 and w2 for lattices voted for twice

/// Returns all parts of an image with these half sides [halves of the longer side]. Tilts are
/// tangents times half the longer side over the focal length: 0.13 is 10 degrees at 24 mm and 20 at
/// 50, 0.36 is 25 at 24 mm. A correlation finds lattices 0.07 away from its own tilt.
std::vector<TiltedPart> allParts(const Vec2& half) {
  std::vector<TiltedPart> parts;
  for (const double share : {1.0, kMiddle, 0.25}) parts.push_back({Vec2::Zero(), share});
  const auto addRing = [&](double tilt, int count, double from) {
    for (int k = 0; k < count; ++k) parts.push_back({tilt * unit(2 * kPi * (k + from) / count), 1});
  };
  addRing(0.13, 6, 0);
  // Parts beside an object, which may be anywhere.
  parts.push_back({Vec2::Zero(), 1});
  for (int k = 0; k < 8; ++k) {
    const int place = k < 4 ? k : k + 1;  // of nine, without the middle
    const int column = place % 3 - 1, row = place / 3 - 1;
    const Vec2 middle(column * (1 - kPartBeside), row * (1 - kPartBeside));
    parts.push_back({Vec2::Zero(), kPartBeside, middle.cwiseProduct(half)});
  }
  addRing(0.25, 12, 0.5);
  addRing(0.36, 14, 0);
  return parts;
}

}  // namespace

bool isSameLattice(const TiltedLattice& a, const TiltedLattice& b, double tolerance) {
  const Mat2 index = a.basis.inverse() * b.basis;
  const Mat2 whole = index.array().rint();
  if (std::abs(std::abs(whole.determinant()) - 1) > 0.5) return false;
  const Mat2 difference = a.basis * whole - b.basis;
  return difference.col(0).norm() < tolerance * b.basis.col(0).norm() &&
         difference.col(1).norm() < tolerance * b.basis.col(1).norm();
}

TiltVotes::TiltVotes(const std::vector<ChannelImage>& levels)
    : levels_(levels),
      parts_(allParts(Vec2(levels[0].width, levels[0].height) /
                      std::max(levels[0].width, levels[0].height))) {
  std::size_t level = 0;
  while (level + 1 < levels.size() &&
         std::max(levels[level].width, levels[level].height) > kLongestVotingPart)
    ++level;
  axes_ = principalAxes(levels[level]);
}

void TiltVotes::vote(int k) {
  const TiltedPart& part = parts_[k];
  std::size_t level = 0;
  while (level + 1 < levels_.size() &&
         part.share * std::max(levels_[level].width, levels_[level].height) > kLongestVotingPart)
    ++level;
  const ChannelImage& image = levels_[level];
  const bool is_beside = k >= kUsual && k < kBeside;
  const Autocorrelation correlation = autocorrelation(
      tiltedPlanes(image, axes_, part, is_beside ? evenWeights(image) : BlockWeights{}),
      static_cast<int>(kShiftReach * part.share * image.width),
      static_cast<int>(kShiftReach * part.share * image.height), kLeastMeeting);
  std::vector<VotedLattice> voted = voteStripes(correlation, kShortestPixels);
  for (const VotedLattice& lattice : voteLattices(correlation, kShortestPixels, kLatticesOfEach))
    voted.push_back(lattice);
  LatticeHypothesis hypothesis;
  TiltedLattice& view = hypothesis.view;
  view.middle = Vec2(image.width, image.height) / (2 * image.scale);
  view.radius = view.middle.maxCoeff();
  view.tilt = part.tilt;
  view.focus = view.radius * part.middle;
  for (const VotedLattice& lattice : voted) {
    for (int c = 0; c < 2; ++c) view.basis.col(c) = lattice.basis[c] / (view.radius * image.scale);
    hypothesis.score = lattice.score;
    hypothesis.is_stripes = lattice.is_stripes;
    add(hypothesis);
    if (part.share == kMiddle) best_of_middle_ = std::max(best_of_middle_, lattice.score);
  }
}

void TiltVotes::add(const LatticeHypothesis& hypothesis) {
  for (LatticeHypothesis& other : hypotheses_) {
    if (!isSameLattice(other.view, hypothesis.view, kSame)) continue;
    if (hypothesis.score > other.score) other = hypothesis;
    return;
  }
  hypotheses_.push_back(hypothesis);
}

std::vector<LatticeHypothesis> TiltVotes::ranked() const {
  std::vector<double> keys(hypotheses_.size());
  for (std::size_t k = 0; k < keys.size(); ++k) keys[k] = -hypotheses_[k].score;
  std::vector<LatticeHypothesis> ranked;
  for (const std::size_t k : placesInOrder(keys)) ranked.push_back(hypotheses_[k]);
  return ranked;
}

}  // namespace seamwise
