#include "alignment/search.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "alignment/candidates.h"
#include "alignment/refine.h"

namespace seamwise {
namespace {

constexpr double kPerfect = 1e-6;      ///< cm2: nothing left to find
constexpr double kWorthRefining = 1.5;  ///< a raw candidate this much worse may still win when refined
constexpr double kHopeless = 2.0;       ///< a start this much worse than the best is dropped
constexpr double kSecondBest = 0.2;     ///< share of pieces placed at their second best candidate
constexpr double kFresh = 0.3;          ///< share of starts from nothing once the first trees are grown

}  // namespace

AlignmentSearch::AlignmentSearch(const MatchProblem& problem, std::uint64_t seed,
                                 SearchBudget budget, double slack)
    : full_(problem), coarse_(problem.coarsened(budget.samples)), budget_(budget), slack_(slack),
      // placing a sample on the print costs about as much as four elements
      sample_cost_(4.0 + static_cast<double>(problem.group.elements().size())), random_(seed),
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
  std::vector<int> parent(full_.leaders.size());
  std::iota(parent.begin(), parent.end(), 0);
  auto root = [&](int i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  auto pinned = [&](int l) { return full_.leaders[l].freedom.isPinned(); };
  for (const MatchSeam& seam : full_.seams)
    if (!pinned(seam.a) && !pinned(seam.b)) parent[root(seam.a)] = root(seam.b);
  std::vector<int> index(full_.leaders.size(), -1);
  for (std::size_t l = 0; l < full_.leaders.size(); ++l) {
    if (pinned(static_cast<int>(l)) || full_.leaders[l].seams.empty()) continue;
    int& at = index[root(static_cast<int>(l))];
    if (at < 0) {
      at = static_cast<int>(components_.size());
      components_.emplace_back();
    }
    components_[at].leaders.push_back(static_cast<int>(l));
  }
  for (Component& c : components_)
    c.allowed = budget_.evaluations * static_cast<double>(c.leaders.size());
}

/// Every candidate's cost towards the placed neighbours (all of them when `placed` is null).
std::vector<double> AlignmentSearch::costsOf(const std::vector<Alignment>& choices, int leader,
                                             const Alignments& at,
                                             const std::vector<char>* placed) {
  std::vector<double> costs(choices.size(), 0);
  std::vector<MatchProblem::Pose> poses;
  for (const Alignment& choice : choices) poses.push_back(coarse_.pose(choice));
  for (int s : coarse_.leaders[leader].seams) {
    const MatchSeam& seam = coarse_.seams[s];
    const int other = seam.a == leader ? seam.b : seam.a;
    if (placed && other != leader && !(*placed)[other]) continue;
    const MatchProblem::Pose fixed = coarse_.pose(at[other]);
    for (std::size_t k = 0; k < choices.size(); ++k) {
      const MatchProblem::Pose& mine = poses[k];
      costs[k] += coarse_.seamCost(seam, seam.a == leader ? mine : fixed,
                                   seam.b == leader ? mine : fixed, slack_);
    }
    spent_ += static_cast<double>(choices.size() * seam.w.size()) * sample_cost_;
  }
  return costs;
}

double AlignmentSearch::componentCost(const Component& c, const Alignments& at,
                                      double slack) const {
  std::vector<char> inside(full_.leaders.size(), 0);
  for (int l : c.leaders) inside[l] = 1;
  double total = 0;
  for (const MatchSeam& seam : coarse_.seams)
    if (inside[seam.a] || inside[seam.b])
      total += coarse_.seamCost(seam, coarse_.pose(at[seam.a]), coarse_.pose(at[seam.b]), slack);
  return total;
}

void AlignmentSearch::place(int leader, Alignments& at, std::vector<char>& placed) {
  placed[leader] = 1;
  const std::vector<Alignment> choices = candidates(coarse_, leader, at, placed);
  if (choices.empty()) {
    at[leader] = randomAlignment(coarse_, leader, random_);
    return;
  }
  const std::vector<double> costs = costsOf(choices, leader, at, &placed);
  std::size_t first = 0, second = 0;
  for (std::size_t k = 1; k < choices.size(); ++k) {
    if (costs[k] < costs[first]) second = first, first = k;
    else if (second == first || costs[k] < costs[second]) second = k;
  }
  at[leader] = choices[random_.uniform() < kSecondBest ? second : first];
}

void AlignmentSearch::grow(const Component& c, Alignments& at, std::vector<char>& placed) {
  for (;;) {
    // the next piece is drawn by the length of its seams to what is placed
    double total = 0;
    std::vector<double> reach(c.leaders.size(), 0);
    bool left = false;
    for (std::size_t i = 0; i < c.leaders.size(); ++i) {
      const int l = c.leaders[i];
      if (placed[l]) continue;
      left = true;
      for (int s : coarse_.leaders[l].seams) {
        const MatchSeam& seam = coarse_.seams[s];
        const int other = seam.a == l ? seam.b : seam.a;
        if (other != l && placed[other]) reach[i] += seam.weight;
      }
      total += reach[i];
    }
    if (!left) return;
    int next = -1;
    if (total <= 0) {
      do next = c.leaders[random_.below(static_cast<int>(c.leaders.size()))];
      while (placed[next]);
      at[next] = randomAlignment(coarse_, next, random_);
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
    place(next, at, placed);
  }
}

bool AlignmentSearch::moveSingles(const Component& c, Alignments& at) {
  bool improved = false;
  std::vector<char> all(full_.leaders.size(), 1);
  const int n = static_cast<int>(c.leaders.size());
  const int offset = random_.below(n);
  for (int k = 0; k < n; ++k) {
    const int l = c.leaders[(k + offset) % n];
    const Alignment present = at[l];
    const double before = costsOf({present}, l, at, nullptr)[0];
    if (before < kPerfect) continue;
    const std::vector<Alignment> choices = candidates(coarse_, l, at, all);
    if (choices.empty()) continue;
    const std::vector<double> costs = costsOf(choices, l, at, nullptr);
    const auto least = std::min_element(costs.begin(), costs.end());
    at[l] = choices[static_cast<std::size_t>(least - costs.begin())];
    double best = *least;
    if (best < kWorthRefining * before) best = refined(at, {l}, 2);
    if (best < before - 1e-6 * before) improved = true;
    else at[l] = present;
  }
  return improved;
}

double AlignmentSearch::refined(Alignments& at, const std::vector<int>& leaders, int iterations) {
  double samples = 0;
  for (int l : leaders)
    for (int s : coarse_.leaders[l].seams) samples += static_cast<double>(coarse_.seams[s].w.size());
  // finding the nearest element and assembling cost a few plain distances a sample and element
  spent_ += iterations * samples * sample_cost_ * 4;
  return refine(coarse_, at, leaders, iterations, slack_);
}

double AlignmentSearch::improve(const Component& c, Alignments& at) {
  double cost = refined(at, c.leaders, 3);
  if (c.cost >= 0 && cost > kHopeless * c.cost) return cost;
  for (int round = 0; round < 4 && cost > kPerfect && moveSingles(c, at); ++round)
    cost = refined(at, c.leaders, 4);
  return cost;
}

void AlignmentSearch::keep(Component& c, const Alignments& at, double cost) {
  if (watch_slack_ > 0) {
    const double watched = componentCost(c, at, watch_slack_);
    if (c.watched_cost < 0 || watched < c.watched_cost) {
      c.watched_cost = watched;
      for (int l : c.leaders) watched_[l] = at[l];
    }
  }
  if (c.cost >= 0 && cost > c.cost - 1e-7 * c.cost - 1e-10) {
    ++c.idle;
    return;
  }
  c.idle = 0;
  c.cost = cost;
  for (int l : c.leaders) best_[l] = at[l];
}

void AlignmentSearch::offer(const Alignments& at) {
  Alignments admissible = at;
  for (std::size_t l = 0; l < at.size(); ++l) {
    const Leader& leader = full_.leaders[l];
    admissible[l] = leader.freedom.nearest(at[l], leader.centre);
  }
  for (Component& c : components_) {
    const double cost = componentCost(c, admissible, slack_);
    if (c.cost < 0 || cost < c.cost) keep(c, admissible, cost);
    Alignments better = admissible;
    keep(c, better, improve(c, better));
  }
}

bool AlignmentSearch::step() {
  if (done_) return false;
  Component& c = components_[current_];
  const double before = spent_;
  const int n = static_cast<int>(c.leaders.size());
  Alignments at = best_;
  std::vector<char> placed(full_.leaders.size(), 1);
  if (c.starts < budget_.trees || c.cost < 0 || random_.uniform() < kFresh) {
    for (int l : c.leaders) placed[l] = 0;
    ++c.starts;
  } else {
    // lift a random connected part and grow it again
    const int size = 1 + random_.below(std::max(1, std::min(n, 1 + n / 2)));
    std::vector<int> part{c.leaders[random_.below(n)]};
    placed[part[0]] = 0;
    for (std::size_t k = 0; k < part.size() && static_cast<int>(part.size()) < size; ++k) {
      for (int s : coarse_.leaders[part[k]].seams) {
        const MatchSeam& seam = coarse_.seams[s];
        const int other = seam.a == part[k] ? seam.b : seam.a;
        if (!placed[other] || full_.leaders[other].freedom.isPinned()) continue;
        if (random_.uniform() < 0.35) continue;
        placed[other] = 0;
        part.push_back(other);
        if (static_cast<int>(part.size()) >= size) break;
      }
    }
    if (part.size() == 1 && random_.uniform() < 0.5) {
      at[part[0]] = randomAlignment(coarse_, part[0], random_);
      placed[part[0]] = 1;
    }
  }
  grow(c, at, placed);
  keep(c, at, improve(c, at));
  c.spent += spent_ - before;
  const bool enough = c.starts >= budget_.trees && c.idle >= budget_.idle * n;
  if (c.cost < kPerfect || enough || c.spent > c.allowed) {
    if (++current_ == components_.size()) {
      polish();
      done_ = true;
    }
  }
  return !done_;
}

double AlignmentSearch::fraction() const {
  if (done_) return 1;
  const Component& c = components_[current_];
  const double share = std::min(1.0, c.spent / c.allowed);
  return (static_cast<double>(current_) + share) / static_cast<double>(components_.size());
}

void AlignmentSearch::polish() {
  std::vector<int> all;
  for (const Component& c : components_) all.insert(all.end(), c.leaders.begin(), c.leaders.end());
  refine(full_, best_, all, 30, slack_);
}

}  // namespace seamwise
