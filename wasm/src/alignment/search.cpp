#include "alignment/search.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "alignment/candidates.h"
#include "alignment/refine.h"

namespace seamwise {
namespace {

constexpr double kPerfect = 1e-6;  ///< cm2: nothing left to find

}  // namespace

AlignmentSearch::AlignmentSearch(const MatchProblem& problem, std::uint64_t seed,
                                 SearchBudget budget, double slack)
    : full_(problem), coarse_(problem.coarsened(budget.samples)), budget_(budget), slack_(slack),
      random_(seed), best_(problem.leaders.size()) {
  for (std::size_t l = 0; l < problem.leaders.size(); ++l) {
    const Leader& leader = problem.leaders[l];
    best_[l] = leader.freedom.nearest({0, leader.centre}, leader.centre);
  }
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
  double total = 0;
  for (const Component& c : components_) total += static_cast<double>(c.leaders.size());
  for (Component& c : components_)
    c.allowed = budget_.evaluations * static_cast<double>(c.leaders.size()) / total;
}

double AlignmentSearch::costAround(int leader, const Alignments& at,
                                   const std::vector<char>* placed) {
  double total = 0;
  for (int s : coarse_.leaders[leader].seams) {
    const MatchSeam& seam = coarse_.seams[s];
    const int other = seam.a == leader ? seam.b : seam.a;
    if (placed && other != leader && !(*placed)[other]) continue;
    total += coarse_.seamCost(seam, at[seam.a], at[seam.b], slack_);
    spent_ += static_cast<double>(seam.w.size() * coarse_.group.elements().size());
  }
  return total;
}

double AlignmentSearch::componentCost(const Component& c, const Alignments& at) const {
  double twice = 0, own = 0;  // seams inside are met from both ends
  std::vector<char> inside(full_.leaders.size(), 0);
  for (int l : c.leaders) inside[l] = 1;
  for (int l : c.leaders) {
    for (int s : coarse_.leaders[l].seams) {
      const MatchSeam& seam = coarse_.seams[s];
      const double cost = coarse_.seamCost(seam, at[seam.a], at[seam.b], slack_);
      if (seam.a != seam.b && inside[seam.a] && inside[seam.b]) twice += cost;
      else own += cost;
    }
  }
  return own + twice / 2;
}

void AlignmentSearch::place(int leader, Alignments& at, std::vector<char>& placed) {
  const std::vector<Alignment> choices = candidates(coarse_, leader, at, placed);
  double best = std::numeric_limits<double>::infinity(), second = best;
  Alignment first_choice, second_choice;
  for (const Alignment& choice : choices) {
    at[leader] = choice;
    const double cost = costAround(leader, at, &placed);
    if (cost < best) {
      second = best, second_choice = first_choice;
      best = cost, first_choice = choice;
    } else if (cost < second) {
      second = cost, second_choice = choice;
    }
  }
  if (choices.empty()) first_choice = randomAlignment(coarse_, leader, random_);
  const bool take_second = choices.size() > 1 && std::isfinite(second) && random_.uniform() < 0.2;
  at[leader] = take_second ? second_choice : first_choice;
  placed[leader] = 1;
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
    const double before = costAround(l, at, nullptr);
    if (before < kPerfect) continue;
    Alignments trial = at;
    double best = before;
    Alignment choice = at[l];
    for (const Alignment& a : candidates(coarse_, l, at, all)) {
      trial[l] = a;
      const double cost = costAround(l, trial, nullptr);
      if (cost < best) best = cost, choice = a;
    }
    if (best < before - 1e-9) {
      at[l] = choice;
      improved = true;
    }
  }
  return improved;
}

double AlignmentSearch::improve(const Component& c, Alignments& at) {
  double samples = 0;
  for (int l : c.leaders)
    for (int s : coarse_.leaders[l].seams) samples += static_cast<double>(coarse_.seams[s].w.size());
  // argmin and assembly cost about as much as twenty plain distances a sample and element
  const double each = samples * static_cast<double>(coarse_.group.elements().size()) * 6;
  double cost = refine(coarse_, at, c.leaders, 6, slack_);
  spent_ += 6 * each;
  for (int round = 0; round < 3 && cost > kPerfect && moveSingles(c, at); ++round) {
    cost = refine(coarse_, at, c.leaders, 6, slack_);
    spent_ += 6 * each;
  }
  return cost;
}

void AlignmentSearch::keep(Component& c, const Alignments& at, double cost) {
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
    const double cost = componentCost(c, admissible);
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
  if (c.starts < budget_.trees || c.cost < 0) {
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
