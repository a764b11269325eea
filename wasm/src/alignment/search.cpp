#include "alignment/search.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "alignment/candidates.h"
#include "alignment/refine.h"

namespace seamwise {
namespace {

constexpr double kPerfect = 2e-5;  ///< cm of mismatch: nothing left to find in single precision
constexpr double kWorthRefining =
    1.5;                             ///< a raw candidate this much worse may still win when refined
constexpr double kHopeless = 1.5;    ///< a start this much worse than the best is dropped
constexpr double kClose = 1.1;       ///< one this much worse is polished
constexpr double kSecondBest = 0.2;  ///< share of pieces placed at their second best candidate
constexpr double kFresh = 0.7;  ///< share of starts from nothing once the first trees are grown
constexpr double kSkip = 0.35;  ///< share of neighbours that a lifted part leaves in place
constexpr std::size_t kFinalists = 3;
constexpr double kSameCost = 2e-3;  ///< answers as alike as this count as one
constexpr double kUnbounded = std::numeric_limits<double>::infinity();

double spacing(const MatchProblem& problem, const SearchBudget& budget) {
  return problem.group.reducedBasis()[0].norm() / budget.samples;
}

}  // namespace

AlignmentSearch::AlignmentSearch(const MatchProblem& problem, std::uint64_t seed,
                                 SearchBudget budget, double slack)
    : problem_(problem),
      samples_(problem, spacing(problem, budget)),
      budget_(budget),
      slack_(slack),
      // placing a sample on the print costs about as much as four elements
      sample_cost_(4.0 + static_cast<double>(problem.group.elements().size())),
      random_(seed),
      best_(problem.leaders.size()) {
  for (std::size_t l = 0; l < problem.leaders.size(); ++l) {
    const Leader& leader = problem.leaders[l];
    best_[l] = leader.freedom.nearest({0, leader.centre}, leader.centre);
  }
  watched_ = best_;
  findComponents();
  done_ = components_.empty();
}

void AlignmentSearch::findComponents() {
  std::vector<int> parent(problem_.leaders.size());
  std::iota(parent.begin(), parent.end(), 0);
  auto root = [&](int i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  auto pinned = [&](int l) { return problem_.leaders[l].freedom.isPinned(); };
  for (const MatchSeam& seam : problem_.seams)
    if (!pinned(seam.a) && !pinned(seam.b)) parent[root(seam.a)] = root(seam.b);
  std::vector<int> index(problem_.leaders.size(), -1);
  for (std::size_t l = 0; l < problem_.leaders.size(); ++l) {
    if (pinned(static_cast<int>(l)) || problem_.leaders[l].seams.empty()) continue;
    int& at = index[root(static_cast<int>(l))];
    if (at < 0) {
      at = static_cast<int>(components_.size());
      components_.emplace_back();
    }
    components_[at].leaders.push_back(static_cast<int>(l));
  }
  for (Component& c : components_) {
    c.allowed = budget_.evaluations * static_cast<double>(c.leaders.size());
    for (int l : c.leaders)
      c.seams.insert(c.seams.end(), problem_.leaders[l].seams.begin(),
                     problem_.leaders[l].seams.end());
    std::sort(c.seams.begin(), c.seams.end());
    c.seams.erase(std::unique(c.seams.begin(), c.seams.end()), c.seams.end());
  }
}

AlignmentSearch::Layout AlignmentSearch::layoutOf(const Alignments& at) const {
  Layout layout{at, {}};
  for (std::size_t l = 0; l < at.size(); ++l)
    layout.poses.push_back(samples_.pose(static_cast<int>(l), at[l]));
  return layout;
}

void AlignmentSearch::set(Layout& layout, int leader, const Alignment& at) const {
  layout.at[leader] = at;
  layout.poses[leader] = samples_.pose(leader, at);
}

/// The cost of a leader's seams to placed neighbours (all when `placed` is null) if it lay at `at`;
/// something above `bound` as soon as it exceeds that.
double AlignmentSearch::costAt(const Alignment& at, int leader, const Layout& layout,
                               const std::vector<char>* placed, double bound) {
  const Samples::Pose mine = samples_.pose(leader, at);
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

double AlignmentSearch::componentCost(const Component& c, const Layout& layout, double slack) {
  double total = 0, samples = 0;
  for (int s : c.seams) {
    const MatchSeam& seam = problem_.seams[s];
    total += samples_.cost(s, layout.poses[seam.a], layout.poses[seam.b], slack);
    samples += samples_.count(s);
  }
  spent_ += samples * sample_cost_;
  return total;
}

void AlignmentSearch::place(int leader, Layout& layout, std::vector<char>& placed) {
  placed[leader] = 1;
  const std::vector<Alignment> choices = candidates(problem_, leader, layout.at, placed);
  if (choices.empty()) {
    set(layout, leader, randomAlignment(problem_, leader, random_));
    return;
  }
  std::size_t first = 0, second = 0;
  double least = kUnbounded, next = kUnbounded;
  for (std::size_t k = 0; k < choices.size(); ++k) {
    const double cost = costAt(choices[k], leader, layout, &placed, next);
    if (cost < least) {
      second = k == 0 ? 0 : first, next = least;
      first = k, least = cost;
    } else if (cost < next) {
      second = k, next = cost;
    }
  }
  set(layout, leader, choices[random_.uniform() < kSecondBest ? second : first]);
}

void AlignmentSearch::grow(const Component& c, Layout& layout, std::vector<char>& placed) {
  for (;;) {
    // the next piece is drawn by the length of its seams to what is placed
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
      set(layout, next, randomAlignment(problem_, next, random_));
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

/// Moves single pieces to their best candidates, those first that are `fresh`: whose surroundings
/// have changed since they were last tried. False when none moved.
bool AlignmentSearch::moveSingles(const Component& c, Layout& layout, std::vector<char>& fresh) {
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
    if (before < kPerfect * samples_.weight()) continue;
    double least = kWorthRefining * before;
    const Alignment* best = nullptr;
    const std::vector<Alignment> choices = candidates(problem_, l, layout.at, all);
    for (const Alignment& choice : choices) {
      const double cost = costAt(choice, l, layout, nullptr, least);
      if (cost < least) least = cost, best = &choice;
    }
    if (!best) continue;
    set(layout, l, *best);
    if (refined(layout, {l}, 1) < before * (1 - 1e-4)) {
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

double AlignmentSearch::refined(Layout& layout, const std::vector<int>& leaders, int iterations) {
  double samples = 0;
  for (int l : leaders)
    for (int s : problem_.leaders[l].seams) samples += samples_.count(s);
  // finding the nearest element and assembling cost a few plain distances a sample and element
  spent_ += iterations * samples * sample_cost_ * 3;
  const double cost = refine(problem_, samples_, layout.at, leaders, iterations, slack_);
  for (int l : leaders) set(layout, l, layout.at[l]);
  return cost;
}

/// Polishes an answer of which the `fresh` leaders are new; cheaply at first, and on only while it
/// may become the best. Returns its cost.
double AlignmentSearch::improve(const Component& c, Layout& layout, std::vector<char> fresh) {
  std::vector<int> changed;
  for (int l : c.leaders)
    if (fresh[l]) changed.push_back(l);
  refined(layout, changed, 3);
  double cost = componentCost(c, layout, slack_);
  for (int l : changed)
    for (int s : problem_.leaders[l].seams)
      fresh[problem_.seams[s].a] = fresh[problem_.seams[s].b] = 1;
  const double perfect = kPerfect * samples_.weight();
  // most regrown parts fall back into place
  if (c.cost >= 0 && std::abs(cost - c.cost) < kSameCost * c.cost) return cost;
  for (int round = 0; round < 4 && cost > perfect; ++round) {
    if (c.cost >= 0 && cost > (round == 0 ? kHopeless : kClose) * c.cost) break;
    const bool moved = moveSingles(c, layout, fresh);
    cost = componentCost(c, layout, slack_);
    if (c.cost < 0 || cost < kClose * c.cost) cost = refined(layout, c.leaders, 4);
    if (!moved) break;
  }
  return cost;
}

void AlignmentSearch::keep(Component& c, const Layout& layout, double cost) {
  Alignments own;
  for (int l : c.leaders) own.push_back(layout.at[l]);
  if (watch_slack_ > 0) {
    const double watched = componentCost(c, layout, watch_slack_);
    if (c.watched_cost < 0 || watched < c.watched_cost) {
      c.watched_cost = watched;
      for (int l : c.leaders) watched_[l] = layout.at[l];
    }
  }
  const double margin = kSameCost * cost + kPerfect * samples_.weight();
  const auto same = std::find_if(c.finalists.begin(), c.finalists.end(), [&](const auto& other) {
    return std::abs(other.first - cost) < margin;
  });
  if (same == c.finalists.end() || cost < same->first) {
    if (same != c.finalists.end()) c.finalists.erase(same);
    const auto after =
        std::upper_bound(c.finalists.begin(), c.finalists.end(), cost,
                         [](double v, const auto& other) { return v < other.first; });
    c.finalists.insert(after, {cost, own});
    if (c.finalists.size() > kFinalists) c.finalists.pop_back();
  }
  if (c.cost >= 0 && cost > c.cost - 1e-5 * c.cost) {
    ++c.idle;
    return;
  }
  c.idle = 0;
  c.cost = cost;
  for (int l : c.leaders) best_[l] = layout.at[l];
}

void AlignmentSearch::offer(const Alignments& at) {
  Alignments admissible = at;
  for (std::size_t l = 0; l < at.size(); ++l) {
    const Leader& leader = problem_.leaders[l];
    admissible[l] = leader.freedom.nearest(at[l], leader.centre);
  }
  offered_.push_back(admissible);
  for (Component& c : components_) {
    Layout layout = layoutOf(admissible);
    keep(c, layout, componentCost(c, layout, slack_));
    std::vector<char> fresh(problem_.leaders.size(), 1);
    keep(c, layout, improve(c, layout, fresh));
  }
}

/// A random connected part of a component, up to half of it.
std::vector<int> AlignmentSearch::randomPart(const Component& c) {
  const int n = static_cast<int>(c.leaders.size());
  const int size = 1 + random_.below(std::max(1, std::min(n, 1 + n / 2)));
  std::vector<int> part{c.leaders[random_.below(n)]};
  for (std::size_t k = 0; k < part.size() && static_cast<int>(part.size()) < size; ++k) {
    for (int s : problem_.leaders[part[k]].seams) {
      const MatchSeam& seam = problem_.seams[s];
      const int other = seam.a == part[k] ? seam.b : seam.a;
      if (std::find(part.begin(), part.end(), other) != part.end()) continue;
      if (problem_.leaders[other].freedom.isPinned() || random_.uniform() < kSkip) continue;
      part.push_back(other);
      if (static_cast<int>(part.size()) >= size) break;
    }
  }
  return part;
}

bool AlignmentSearch::step() {
  if (done_) return false;
  Component& c = components_[current_];
  const double before = spent_;
  const int n = static_cast<int>(c.leaders.size());
  Layout layout = layoutOf(best_);
  std::vector<char> placed(problem_.leaders.size(), 1), fresh(problem_.leaders.size(), 0);
  std::vector<int> part = c.leaders;
  const bool anew = c.starts < budget_.trees || c.cost < 0 || random_.uniform() < kFresh;
  if (anew)
    ++c.starts;
  else
    part = randomPart(c);
  for (int l : part) placed[l] = 0, fresh[l] = 1;
  if (part.size() == 1 && n > 1 && random_.uniform() < 0.5) {
    set(layout, part[0], randomAlignment(problem_, part[0], random_));
    placed[part[0]] = 1;
  }
  grow(c, layout, placed);
  const double cost = improve(c, layout, fresh), known = c.cost;
  keep(c, layout, cost);
  if (known < 0 || c.cost < known * (1 - kSameCost)) c.hits = 0;
  if (anew && cost < c.cost * (1 + kSameCost)) ++c.hits;
  c.spent += spent_ - before;
  const bool enough =
      c.starts >= budget_.trees && (c.hits >= budget_.hits || c.idle >= budget_.idle * (n + 4));
  if (c.cost < kPerfect * samples_.weight() || enough || c.spent > c.allowed) {
    polish(c);
    if (++current_ == components_.size()) done_ = true;
  }
  return !done_;
}

double AlignmentSearch::fraction() const {
  if (done_) return 1;
  const Component& c = components_[current_];
  const double share = std::min(1.0, c.spent / c.allowed);
  return (static_cast<double>(current_) + share) / static_cast<double>(components_.size());
}

/// Compares the finalists and what was offered on all edges of the seams.
void AlignmentSearch::polish(Component& c) {
  const SampledSeams<double> exact(problem_, 0);
  for (const Alignments& at : offered_) {
    c.finalists.emplace_back();
    for (int l : c.leaders) c.finalists.back().second.push_back(at[l]);
  }
  double least = kUnbounded;
  Alignments at = best_;
  for (const auto& [cost, own] : c.finalists) {
    for (std::size_t i = 0; i < own.size(); ++i) at[c.leaders[i]] = own[i];
    const double reached = refine(problem_, exact, at, c.leaders, 30, slack_);
    if (reached >= least) continue;
    least = reached;
    best_ = at;
  }
}

}  // namespace seamwise
