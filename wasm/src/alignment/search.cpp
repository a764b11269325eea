#include "alignment/search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include "alignment/refine.h"

namespace seamwise {
namespace {

/// Share of starts from nothing once the first trees are grown; of many pieces, some lie badly in
/// each of them, and parts of the best are worth more.
double freshShare(int pieces) { return std::min(0.7, 5.0 / pieces); }
/// And the more of them, the longer it takes until nothing is to be gained. With few, thousands of
/// answers are within reach, and looking at more of them takes little time.
double patienceFor(double pieces) {
  return std::clamp(std::max(pieces / 10, 8 / pieces), 1.0, 2.0);
}
constexpr double kScattered = 0.3;  ///< share of these whose pieces lie anywhere, not grown
constexpr double kOther = 0.3;      ///< share of regrowths of another answer than the best
constexpr double kDetached = 0.5;   ///< share of regrowths that begin anywhere, apart from the rest
constexpr std::size_t kFinalists = 16;
constexpr double kEqual = 1e-6;  ///< answers whose costs differ by less are as good as each other
constexpr int kGlance = 3;       ///< iterations on all edges that tell which finalists go on
constexpr std::size_t kPolished = 12;
constexpr int kPolish = 30;  ///< iterations at most

constexpr double kProof = 0.03;       ///< share of the evaluations that may go into a proof,
constexpr int kProvable = 5;          ///< where no more unknowns than these make it likely
constexpr double kProofDistance = 5;  ///< a distance there takes as long as so many elsewhere
constexpr double kSought = 0.6;       ///< share of the time before a proof, as a rule

/// The more symmetries a print has, the more answers there are to choose from.
SearchBudget enlarged(SearchBudget budget, int symmetries) {
  const double ratio = symmetries / 4.0, more = std::max(1.0, ratio * std::sqrt(std::sqrt(ratio)));
  budget.trees = static_cast<int>(budget.trees * more);
  budget.idle = static_cast<int>(budget.idle * more);
  budget.hits = static_cast<int>(budget.hits * more);
  budget.evaluations *= more;
  return budget;
}

}  // namespace

AlignmentSearch::AlignmentSearch(const MatchProblem& problem, std::uint64_t seed,
                                 SearchBudget budget, double slack)
    : problem_(problem),
      budget_(enlarged(budget, problem.group.data().order)),
      moves_(problem, seed, budget.samples, slack),
      best_(problem.leaders.size()) {
  for (std::size_t l = 0; l < problem.leaders.size(); ++l) {
    const Leader& leader = problem.leaders[l];
    best_[l] = leader.freedom.nearest({0, leader.centre}, leader.centre);
  }
  watched_ = best_;
  findComponents();
  done_ = components_.empty();
  fraction_ = done_ ? 1 : 0;
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
  for (Searched& c : components_) {
    const double pieces = static_cast<double>(c.leaders.size());
    c.allowed = budget_.evaluations * pieces * patienceFor(pieces);
    c.patience = budget_.idle * (pieces + 4) * patienceFor(pieces);
    for (int l : c.leaders)
      c.seams.insert(c.seams.end(), problem_.leaders[l].seams.begin(),
                     problem_.leaders[l].seams.end());
    std::sort(c.seams.begin(), c.seams.end());
    c.seams.erase(std::unique(c.seams.begin(), c.seams.end()), c.seams.end());
  }
}

void AlignmentSearch::keep(Searched& c, const Layout& layout, double cost) {
  Alignments own;
  for (int l : c.leaders) own.push_back(layout.at[l]);
  if (watch_slack_ > 0) {
    const double watched = moves_.costOf(c, layout, watch_slack_);
    if (c.watched_cost < 0 || watched < c.watched_cost) {
      c.watched_cost = watched;
      for (int l : c.leaders) watched_[l] = layout.at[l];
    }
  }
  const double margin = SearchMoves::kSame * cost + moves_.perfect();
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
  for (Searched& c : components_) {
    Layout layout = moves_.layoutOf(admissible);
    keep(c, layout, moves_.costOf(c, layout, moves_.slack()));
    std::vector<char> fresh(problem_.leaders.size(), 1);
    keep(c, layout, moves_.improve(c, layout, fresh, c.cost));
  }
}

/// The answer that a step goes on from: now and then one of the others that are good.
Alignments AlignmentSearch::before(const Searched& c) {
  Alignments at = best_;
  if (moves_.uniform() >= kOther) return at;
  const Alignments& own = c.finalists[moves_.below(static_cast<int>(c.finalists.size()))].second;
  for (std::size_t i = 0; i < own.size(); ++i) at[c.leaders[i]] = own[i];
  return at;
}

bool AlignmentSearch::step() {
  if (done_) return false;
  Searched& c = components_[current_];
  if (proof_) {
    const double allowed = proofAllowed(c);
    const bool more = proof_->spent() < allowed && proof_->step();
    progress(kSought + (1 - kSought) * std::min(1.0, proof_->spent() / allowed));
    if (more) return true;
    endProof(c);
    return endComponent();
  }
  const double spent = moves_.spent();
  const int n = static_cast<int>(c.leaders.size());
  const bool anew = c.starts < budget_.trees || moves_.uniform() < freshShare(n);
  Layout layout = moves_.layoutOf(anew ? best_ : before(c));
  Component part = c;
  if (anew)
    ++c.starts;
  else
    part.leaders = moves_.randomPart(c);
  std::vector<char> fresh(problem_.leaders.size(), 0);
  for (int l : part.leaders) fresh[l] = 1;
  // the very first answer is shown, so it is grown
  if (c.cost < 0 || moves_.uniform() >= (anew ? kScattered : kDetached)) {
    std::vector<char> placed(fresh.size());
    for (std::size_t l = 0; l < placed.size(); ++l) placed[l] = !fresh[l];
    moves_.grow(part, layout, placed);
  } else if (anew) {
    for (int l : part.leaders) moves_.layAnywhere(l, layout);
  } else {
    std::vector<char> placed(fresh.size(), 0);
    moves_.layAnywhere(part.leaders[0], layout);
    placed[part.leaders[0]] = 1;
    moves_.grow(part, layout, placed);
  }
  const double cost = moves_.improve(c, layout, fresh, c.cost), known = c.cost;
  keep(c, layout, cost);
  if (known < 0 || c.cost < known * (1 - SearchMoves::kSame)) c.hits = 0;
  if (anew && cost < c.cost * (1 + SearchMoves::kSame)) ++c.hits;
  c.spent += moves_.spent() - spent;
  const bool enough = c.starts >= budget_.trees && (c.hits >= budget_.hits || c.idle >= c.patience);
  const double share = std::min(1.0, std::max(c.spent / c.allowed, c.idle / c.patience));
  if (c.cost < moves_.perfect() || enough || c.spent > c.allowed) {
    const double polished = polish(c);
    if (polished < moves_.perfect() || proofAllowed(c) == 0) {
      cost_ += polished;
      bound_ += polished < moves_.perfect() ? polished : 0;
      return endComponent();
    }
    proof_ = std::make_unique<LowerBound>(problem_, c, best_);
  }
  progress(proof_ ? kSought : proofAllowed(c) > 0 ? kSought * share : share);
  return true;
}

/// Of the present component, `share` is done.
void AlignmentSearch::progress(double share) {
  fraction_ = std::max(
      fraction_, (static_cast<double>(current_) + share) / static_cast<double>(components_.size()));
}

double AlignmentSearch::proofAllowed(const Searched& c) const {
  if (moves_.slack() > 0) return 0;
  int unknowns = 0;
  for (int l : c.leaders)
    unknowns += static_cast<int>(problem_.leaders[l].freedom.basis(best_[l]).cols());
  return budget_.proof.value_or(unknowns > kProvable ? 0 : kProof) * c.allowed;
}

/// Whatever better answer the proof has met is the best.
void AlignmentSearch::endProof(const Searched& c) {
  for (int l : c.leaders) best_[l] = proof_->best()[l];
  cost_ += proof_->cost();
  bound_ += proof_->proven() ? proof_->cost() : proof_->bound();
  proof_spent_ += proof_->spent();
  proof_.reset();
}

bool AlignmentSearch::endComponent() {
  ++current_;
  fraction_ = static_cast<double>(current_) / static_cast<double>(components_.size());
  done_ = current_ == components_.size();
  return !done_;
}

double AlignmentSearch::bound() const { return cost_ > 0 ? bound_ / cost_ : 1; }

double AlignmentSearch::spent() const {
  return moves_.spent() + kProofDistance * (proof_spent_ + (proof_ ? proof_->spent() : 0));
}

/// Compares the finalists and what was offered on all edges of the seams; of answers that are as
/// good as each other, what was offered stands. Returns the least cost.
double AlignmentSearch::polish(Searched& c) {
  const SampledSeams<double> exact(problem_, 0);
  std::vector<std::pair<double, Alignments>> all;
  for (const Alignments& at : offered_) {
    all.emplace_back();
    for (int l : c.leaders) all.back().second.push_back(at[l]);
  }
  all.insert(all.end(), c.finalists.begin(), c.finalists.end());
  // by position, so that what was offered stays told from the others
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), 0);
  const auto sort = [&](int iterations) {
    for (const std::size_t k : order) all[k].first = polished(c, all[k].second, exact, iterations);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return std::tie(all[a].first, a) < std::tie(all[b].first, b);
    });
  };
  sort(kGlance);
  if (order.size() > kPolished) order.resize(kPolished);
  sort(kPolish);
  c.finalists.clear();
  for (std::size_t k = 0; k < order.size();) {
    const double least = all[order[k]].first;
    std::size_t first = order[k];
    for (; k < order.size() && all[order[k]].first <= least * (1 + SearchMoves::kSame); ++k)
      if (all[order[k]].first <= least * (1 + kEqual)) first = std::min(first, order[k]);
    c.finalists.push_back(all[first]);
  }
  const auto& [cost, own] = c.finalists.front();
  for (std::size_t i = 0; i < own.size(); ++i) best_[c.leaders[i]] = own[i];
  return cost;
}

std::vector<Alignments> AlignmentSearch::bestFew() const {
  std::size_t count = 1;
  for (const Searched& c : components_) count = std::max(count, c.finalists.size());
  std::vector<Alignments> few(count, best_);
  for (const Searched& c : components_) {
    for (std::size_t k = 1; k < count; ++k) {
      const Alignments& own = c.finalists[std::min(k, c.finalists.size() - 1)].second;
      for (std::size_t i = 0; i < own.size(); ++i) few[k][c.leaders[i]] = own[i];
    }
  }
  return few;
}

/// Improves an answer for a component on `seams`. Returns its cost.
double AlignmentSearch::polished(const Searched& c, Alignments& own,
                                 const SampledSeams<double>& seams, int iterations) const {
  Alignments at = best_;
  for (std::size_t i = 0; i < own.size(); ++i) at[c.leaders[i]] = own[i];
  const double cost = refine(problem_, seams, at, c.leaders, iterations, moves_.slack());
  for (std::size_t i = 0; i < own.size(); ++i) own[i] = at[c.leaders[i]];
  return cost;
}

}  // namespace seamwise
