#include "alignment/search/search.h"

#include <algorithm>
#include <cmath>

#include "alignment/icp/refine.h"
#include "alignment/search/finalists.h"
#include "tuning/progress.h"
#include "tuning/proof.h"
#include "tuning/search.h"

namespace seamwise {
namespace {

/// Prints with more symmetries have more answers to choose from.
SearchBudget enlarged(SearchBudget budget, int symmetries) {
  const double ratio = symmetries / SearchTuning::kSymmetries,
               more = std::max(1.0, ratio * std::sqrt(std::sqrt(ratio)));
  budget.trees = static_cast<int>(budget.trees * more);
  budget.idle = std::floor(budget.idle * more);
  budget.hits = static_cast<int>(budget.hits * more);
  budget.evaluations *= more;
  return budget;
}

/// The budget of one share.
SearchBudget divided(SearchBudget budget) {
  budget.trees = (budget.trees + budget.shares - 1) / budget.shares;
  budget.idle /= budget.shares;
  budget.hits = (budget.hits + budget.shares - 1) / budget.shares;
  budget.evaluations /= budget.shares;
  return budget;
}

void put(const Component& c, const Alignments& own, Alignments& all) {
  for (std::size_t i = 0; i < own.size(); ++i) all[c.leaders[i]] = own[i];
}

Alignments ownOf(const Component& c, const Alignments& all) {
  Alignments own;
  for (int l : c.leaders) own.push_back(all[l]);
  return own;
}

}  // namespace

AlignmentSearch::AlignmentSearch(const MatchProblem& problem, std::uint64_t seed,
                                 SearchBudget budget, double slack)
    : problem_(problem),
      budget_(enlarged(budget, problem.group.data().order)),
      seed_(seed),
      components_(componentsOf(problem)),
      samples_(searchSamples(problem, budget)),
      moves_(problem, samples_, seed, slack),
      known_(components_.size()),
      shown_(components_.size(), -1) {
  for (const Leader& leader : problem.leaders)
    best_.push_back(leader.admissible.nearest({0, leader.centre}, leader.centre));
  progress();
}

void AlignmentSearch::offer(const Alignments& at) {
  Alignments admissible = at;
  for (std::size_t l = 0; l < at.size(); ++l) {
    const Leader& leader = problem_.leaders[l];
    admissible[l] = leader.admissible.nearest(at[l], leader.centre);
  }
  offered_.push_back(admissible);
  for (std::size_t k = 0; k < components_.size(); ++k) {
    const Component& c = components_[k];
    Answers& known = known_[k];
    Layout layout = moves_.layoutOf(admissible);
    const auto keep = [&](double cost) {
      const Alignments own = ownOf(c, layout.at);
      if (watch_slack_ > 0) known.watch(moves_.costOf(c, layout, watch_slack_), own);
      known.add(cost, own, moves_.perfect());
    };
    keep(moves_.costOf(c, layout, moves_.slack()));
    const std::vector<char> fresh(problem_.leaders.size(), 1);
    keep(moves_.improve(c, layout, fresh, known.cost()));
    show(k, known);
  }
}

/// Stores a component's best answer so far in best_, for display.
void AlignmentSearch::show(std::size_t component, const Answers& answers) {
  double& shown = shown_[component];
  if (answers.few.empty() || (shown >= 0 && answers.cost() >= shown)) return;
  shown = answers.cost();
  put(components_[component], answers.few[0].second, best_);
}

void AlignmentSearch::split() {
  for (int k = 0; k < budget_.shares; ++k) {
    auto share = std::make_shared<Share>();
    const std::uint64_t shares = static_cast<std::uint64_t>(budget_.shares);
    const std::uint64_t seed = Random(shares * seed_ + static_cast<std::uint64_t>(k)).bits();
    share->task = {divided(budget_), seed, moves_.slack(), watch_slack_, best_, known_};
    shares_.push_back(std::move(share));
  }
}

std::shared_ptr<AlignmentSearch::Share> AlignmentSearch::lend() {
  if (merged_) return nullptr;
  if (shares_.empty()) split();
  // Lend from the end, because shares are run here from the beginning.
  const auto free =
      std::find_if(shares_.rbegin(), shares_.rend(), [](const auto& s) { return !s->begun; });
  if (free == shares_.rend()) return nullptr;
  (*free)->begun = true;
  return *free;
}

/// Returns whether a share has found a perfect answer for a component.
bool AlignmentSearch::isSettled(std::size_t component, std::size_t share) const {
  const auto& answers = shares_[share]->answers;
  return answers && (*answers)[component].isPerfect(moves_.perfect());
}

/// Returns the share to run here; null when all necessary answers are available.
AlignmentSearch::Share* AlignmentSearch::nextShare() {
  Share* lent = nullptr;
  for (std::size_t s = 0; s < shares_.size(); ++s) {
    Share& share = *shares_[s];
    if (!share.answers) {
      if (&share == running_ || !share.begun) return &share;
      if (!lent) lent = &share;
      continue;
    }
    bool settled = !lent;
    for (std::size_t k = 0; settled && k < components_.size(); ++k) settled = isSettled(k, s);
    if (settled) return nullptr;
  }
  return lent;
}

void AlignmentSearch::run(Share& share) {
  if (&share != running_) {
    if (local_) spent_ += local_->spent();
    running_ = &share;
    share.begun = true;
    ShareTask task = share.task;
    // Components that earlier shares have settled need no other answer.
    for (std::size_t s = 0; shares_[s].get() != &share; ++s)
      for (std::size_t k = 0; k < components_.size(); ++k)
        if (isSettled(k, s)) task.known[k] = (*shares_[s]->answers)[k];
    local_ = std::make_unique<SearchShare>(problem_, components_, samples_, std::move(task));
  }
  const std::size_t component = local_->current();
  const bool more = local_->step();
  if (component < components_.size()) show(component, local_->answers()[component]);
  if (!more) share.answers = local_->answers();
}

/// Merges answers in the order of the shares, without those after a perfect one.
void AlignmentSearch::merge() {
  for (std::size_t k = 0; k < components_.size(); ++k) {
    for (std::size_t s = 0; s < shares_.size(); ++s) {
      known_[k].add((*shares_[s]->answers)[k], moves_.perfect());
      if (isSettled(k, s)) break;
    }
    put(components_[k], known_[k].few[0].second, best_);
  }
  merged_ = true;
  running_ = nullptr;
}

bool AlignmentSearch::step() {
  if (current_ == components_.size()) return false;
  if (shares_.empty()) split();
  if (proof_) {
    prove();
  } else if (merged_) {
    const double cost = polish(current_);
    if (cost < moves_.perfect())
      endComponent(cost, cost);
    else if (proofAllowed(components_[current_]) == 0)
      endComponent(cost, 0);
    else
      proof_ = std::make_unique<LowerBound>(problem_, components_[current_], best_);
  } else if (Share* share = nextShare()) {
    run(*share);
  } else {
    merge();
  }
  progress();
  return current_ < components_.size();
}

void AlignmentSearch::progress() {
  if (components_.empty()) fraction_ = 1;
  if (components_.empty()) return;
  const auto provable = [this](const Component& c) { return proofAllowed(c) > 0; };
  const bool proves = std::any_of(components_.begin(), components_.end(), provable);
  const double sought = proves ? ProgressTuning::kBeforeProof : 1;
  double fraction = 0;
  if (merged_) {
    const double part =
        proof_ ? std::min(1.0, proof_->spent() / proofAllowed(components_[current_])) : 0;
    fraction = sought + (1 - sought) * (static_cast<double>(current_) + part) /
                            static_cast<double>(components_.size());
  } else {
    for (const auto& share : shares_)
      fraction += share->answers ? 1 : share.get() == running_ ? local_->fraction() : 0;
    fraction *= sought / budget_.shares;
  }
  fraction_ = std::max(fraction_, fraction);
}

double AlignmentSearch::proofAllowed(const Component& c) const {
  if (moves_.slack() > 0) return 0;
  int unknowns = 0;
  for (int l : c.leaders)
    unknowns += static_cast<int>(problem_.leaders[l].admissible.basis(best_[l]).cols());
  return budget_.proof.value_or(unknowns > ProofTuning::kProvable ? 0 : ProofTuning::kWorkShare) *
         allowedIn(c, budget_);
}

void AlignmentSearch::prove() {
  const Component& c = components_[current_];
  if (proof_->spent() < proofAllowed(c) && proof_->step()) return;
  // The proof may have found a better answer.
  for (int l : c.leaders) best_[l] = proof_->best()[l];
  proof_spent_ += proof_->spent();
  const std::unique_ptr<LowerBound> ended = std::move(proof_);
  endComponent(ended->cost(), ended->proven() ? ended->cost() : ended->bound());
}

void AlignmentSearch::endComponent(double cost, double bound) {
  cost_ += cost;
  bound_ += bound;
  ++current_;
}

double AlignmentSearch::bound() const { return cost_ > 0 ? bound_ / cost_ : 1; }

double AlignmentSearch::spent() const {
  return moves_.spent() + spent_ + (local_ ? local_->spent() : 0) +
         ProofTuning::kDistanceWork * (proof_spent_ + (proof_ ? proof_->spent() : 0));
}

/// Compares the finalists and the offered answers on all edges of the seams. An offered answer has
/// precedence over equally good ones. Returns the least cost.
double AlignmentSearch::polish(std::size_t component) {
  const Component& c = components_[component];
  auto& few = known_[component].few;
  const SampledSeams<double> exact(problem_, 0);
  std::vector<std::pair<double, Alignments>> all;
  for (const Alignments& at : offered_) all.emplace_back(0, ownOf(c, at));
  all.insert(all.end(), few.begin(), few.end());
  few = finalistsOf(std::move(all), [&](Alignments& own, int iterations) {
    return polished(c, own, exact, iterations);
  });
  put(c, few[0].second, best_);
  return few[0].first;
}

/// Improves an answer for a component on `seams`. Returns its cost.
double AlignmentSearch::polished(const Component& c, Alignments& own,
                                 const SampledSeams<double>& seams, int iterations) const {
  Alignments at = best_;
  put(c, own, at);
  const double cost = refine(problem_, seams, at, c.leaders, iterations, moves_.slack());
  own = ownOf(c, at);
  return cost;
}

Alignments AlignmentSearch::watched() const {
  Alignments at = best_;
  for (std::size_t k = 0; k < components_.size(); ++k) put(components_[k], known_[k].watched, at);
  return at;
}

std::vector<Alignments> AlignmentSearch::bestFew() const {
  std::size_t count = 1;
  for (const Answers& known : known_) count = std::max(count, known.few.size());
  std::vector<Alignments> all(count, best_);
  for (std::size_t k = 0; k < components_.size(); ++k) {
    const auto& few = known_[k].few;
    for (std::size_t i = 1; i < count; ++i)
      put(components_[k], few[std::min(i, few.size() - 1)].second, all[i]);
  }
  return all;
}

}  // namespace seamwise
