#include "alignment/search/search_moves.h"

#include <algorithm>
#include <limits>

#include "alignment/icp/refine.h"
#include "alignment/search/candidates.h"
#include "tuning/search.h"

namespace seamwise {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

}  // namespace

SearchMoves::SearchMoves(const MatchProblem& problem, const SearchSamples& samples,
                         std::uint64_t seed, double slack)
    : problem_(problem),
      samples_(samples),
      slack_(slack),
      sample_cost_(samples_.sampleCost()),
      random_(seed) {}

Layout SearchMoves::layoutOf(const Alignments& at) const {
  Layout layout{at, {}};
  for (std::size_t l = 0; l < at.size(); ++l)
    layout.poses.push_back(samples_.pose(static_cast<int>(l), at[l]));
  return layout;
}

void SearchMoves::layAnywhere(int leader, Layout& layout) {
  set(layout, leader, randomAlignment(problem_, leader, random_));
}

void SearchMoves::set(Layout& layout, int leader, const Alignment& at) const {
  layout.at[leader] = at;
  layout.poses[leader] = samples_.pose(leader, at);
}

/// The cost of a leader's seams to placed neighbours (all if `placed` is null) at an alignment;
/// some value above `bound` as soon as it exceeds that.
double SearchMoves::costAt(const Alignment& at, int leader, const Layout& layout,
                           const std::vector<char>* placed, double bound) {
  const SearchSamples::Pose mine = samples_.pose(leader, at);
  double cost = 0, samples = 0;
  for (int s : problem_.leaders[leader].seams) {
    const MatchSeam& seam = problem_.seams[s];
    const int other = seam.a == leader ? seam.b : seam.a;
    if (placed && other != leader && !(*placed)[other]) continue;
    cost += samples_.cost(s, seam.a == leader ? mine : layout.poses[seam.a],
                          seam.b == leader ? mine : layout.poses[seam.b], slack_);
    samples += samples_.count(s);
    if (cost > bound) break;
  }
  spent_ += samples * sample_cost_;
  return cost;
}

double SearchMoves::costOf(const Component& c, const Layout& layout, double slack) {
  double total = 0, samples = 0;
  for (int s : c.seams) {
    const MatchSeam& seam = problem_.seams[s];
    total += samples_.cost(s, layout.poses[seam.a], layout.poses[seam.b], slack);
    samples += samples_.count(s);
  }
  spent_ += samples * sample_cost_;
  return total;
}

void SearchMoves::place(int leader, Layout& layout, std::vector<char>& placed) {
  placed[leader] = 1;
  const std::vector<Alignment> choices =
      candidates(problem_, leader, layout.at, placed, SearchTuning::kStretches, random_);
  if (choices.empty()) {
    layAnywhere(leader, layout);
    return;
  }
  std::size_t first = 0, second = 0;
  double least = kUnbounded, next = kUnbounded;
  for (std::size_t k = 0; k < choices.size(); ++k) {
    const double cost = costAt(choices[k], leader, layout, &placed, next);
    if (cost < least) {
      second = first, next = least;
      first = k, least = cost;
    } else if (cost < next) {
      second = k, next = cost;
    }
  }
  set(layout, leader, choices[random_.uniform() < SearchTuning::kSecondBest ? second : first]);
}

void SearchMoves::grow(const Component& c, Layout& layout, std::vector<char>& placed) {
  for (;;) {
    // The next piece is random, weighted by the length of its seams to placed ones.
    double total = 0;
    std::vector<double> reach(c.leaders.size(), 0);
    std::vector<int> left;
    for (std::size_t i = 0; i < c.leaders.size(); ++i) {
      const int l = c.leaders[i];
      if (placed[l]) continue;
      left.push_back(l);
      for (int s : problem_.leaders[l].seams) {
        const MatchSeam& seam = problem_.seams[s];
        const int other = seam.a == l ? seam.b : seam.a;
        if (other != l && placed[other]) reach[i] += seam.weight;
      }
      total += reach[i];
    }
    if (left.empty()) return;
    int next = -1;
    if (total <= 0) {
      next = left[random_.below(static_cast<int>(left.size()))];
      layAnywhere(next, layout);
      placed[next] = 1;
      continue;
    }
    double draw = random_.uniform() * total;
    for (std::size_t i = 0; i < c.leaders.size(); ++i) {
      if (reach[i] <= 0) continue;
      next = c.leaders[i];
      draw -= reach[i];
      if (draw <= 0) break;
    }
    place(next, layout, placed);
  }
}

/// Moves single `fresh` pieces, whose surroundings have changed since the last try, to their best
/// candidates. Returns false if none moved.
bool SearchMoves::moveSingles(const Component& c, Layout& layout, std::vector<char>& fresh) {
  bool improved = false;
  const std::vector<char> all(problem_.leaders.size(), 1);
  const int n = static_cast<int>(c.leaders.size());
  const int offset = random_.below(n);
  for (int k = 0; k < n; ++k) {
    const int l = c.leaders[(k + offset) % n];
    if (!fresh[l]) continue;
    fresh[l] = 0;
    const Alignment present = layout.at[l];
    const double before = costAt(present, l, layout, nullptr, kUnbounded);
    if (before < perfect()) continue;
    double least = SearchTuning::kWorthRefining * before;
    const Alignment* best = nullptr;
    const std::vector<Alignment> choices = candidates(problem_, l, layout.at, all, 0, random_);
    for (const Alignment& choice : choices) {
      const double cost = costAt(choice, l, layout, nullptr, least);
      if (cost < least) least = cost, best = &choice;
    }
    if (!best) continue;
    set(layout, l, *best);
    if (refined(layout, {l}, 1) < before * (1 - SearchTuning::kMoveGain)) {
      improved = true;
      for (int s : problem_.leaders[l].seams)
        fresh[problem_.seams[s].a] = fresh[problem_.seams[s].b] = 1;
      fresh[l] = 0;
    } else {
      set(layout, l, present);
    }
  }
  return improved;
}

double SearchMoves::refined(Layout& layout, const std::vector<int>& leaders, int iterations) {
  double samples = 0;
  for (int l : leaders)
    for (int s : problem_.leaders[l].seams) samples += samples_.count(s);
  // The nearest element and the assembly cost a few plain distances per sample and element.
  spent_ += iterations * samples * sample_cost_ * SearchTuning::kModelWork;
  double work = 0;
  const double cost = refine(problem_, samples_, layout.at, leaders, iterations, slack_, &work);
  spent_ += work / SearchTuning::kMultiplications;
  for (int l : leaders) set(layout, l, layout.at[l]);
  return cost;
}

double SearchMoves::improve(const Component& c, Layout& layout, std::vector<char> fresh,
                            double known) {
  std::vector<int> changed;
  for (int l : c.leaders)
    if (fresh[l]) changed.push_back(l);
  refined(layout, changed, SearchTuning::kFreshIterations);
  double cost = costOf(c, layout, slack_);
  for (int l : changed)
    for (int s : problem_.leaders[l].seams)
      fresh[problem_.seams[s].a] = fresh[problem_.seams[s].b] = 1;
  const double nothing = perfect();
  // Most regrown parts return to their place.
  if (known >= 0 && std::abs(cost - known) < SearchTuning::kSameAnswer * known) return cost;
  for (int round = 0; round < SearchTuning::kRounds && cost > nothing; ++round) {
    if (known >= 0 && cost > (round == 0 ? SearchTuning::kPruned : SearchTuning::kClose) * known)
      break;
    const bool moved = moveSingles(c, layout, fresh);
    cost = costOf(c, layout, slack_);
    if (known < 0 || cost < SearchTuning::kClose * known)
      cost = refined(layout, c.leaders, SearchTuning::kRoundIterations);
    if (!moved) break;
  }
  return cost;
}

std::vector<int> SearchMoves::randomPart(const Component& c) {
  const int n = static_cast<int>(c.leaders.size());
  const int size = 1 + random_.below(std::max(1, std::min(n, 1 + n / 2)));
  std::vector<int> part{c.leaders[random_.below(n)]};
  for (std::size_t k = 0; k < part.size() && static_cast<int>(part.size()) < size; ++k) {
    for (int s : problem_.leaders[part[k]].seams) {
      const MatchSeam& seam = problem_.seams[s];
      const int other = seam.a == part[k] ? seam.b : seam.a;
      if (std::find(part.begin(), part.end(), other) != part.end()) continue;
      if (problem_.leaders[other].admissible.isPinned() ||
          random_.uniform() < SearchTuning::kSkipped)
        continue;
      part.push_back(other);
      if (static_cast<int>(part.size()) >= size) break;
    }
  }
  return part;
}

}  // namespace seamwise
