#include "alignment/search/search_share.h"

#include <algorithm>
#include <cmath>

#include "tuning/search.h"

namespace seamwise {
namespace {

/// Share of starts from nothing after the first trees. Among many pieces, some are badly placed in
/// each of them, and parts of the best are worth more.
double freshShare(int pieces) {
  return std::min(SearchTuning::kFreshShare, SearchTuning::kFreshPieces / pieces);
}
/// Factor of the patience. More pieces take longer until nothing can be gained. Few pieces leave
/// thousands of answers within reach, and trying more of them takes little time.
double patienceFor(double pieces) {
  return std::clamp(std::max(pieces / SearchTuning::kManyPieces, SearchTuning::kFewPieces / pieces),
                    1.0, SearchTuning::kMostPatience);
}
/// The number of pieces that time is allowed for. All pieces sewn together take part in each step,
/// so the allowance per piece falls beyond some number: one garment must not take minutes.
double countedOf(double pieces) {
  constexpr double kMany = SearchTuning::kCountedPieces;
  return pieces <= kMany ? pieces : kMany * std::sqrt(kMany / pieces);
}

}  // namespace

SearchSamples searchSamples(const MatchProblem& problem, const SearchBudget& budget) {
  return {problem, problem.group.reducedBasis()[0].norm() / budget.samples};
}

double allowedIn(const Component& component, const SearchBudget& budget) {
  const double pieces = static_cast<double>(component.leaders.size());
  return budget.evaluations * countedOf(pieces) * patienceFor(pieces);
}

void Answers::add(double cost, const Alignments& own, double perfect) {
  const double margin = SearchTuning::kSameAnswer * cost + perfect;
  const auto same = std::find_if(few.begin(), few.end(), [&](const auto& other) {
    return std::abs(other.first - cost) < margin;
  });
  if (same != few.end()) {
    if (cost >= same->first) return;
    few.erase(same);
  }
  const auto after = std::upper_bound(few.begin(), few.end(), cost,
                                      [](double v, const auto& other) { return v < other.first; });
  few.insert(after, {cost, own});
  if (few.size() > SearchTuning::kFinalists) few.pop_back();
}

void Answers::watch(double cost, const Alignments& own) {
  if (watched_cost >= 0 && cost >= watched_cost) return;
  watched_cost = cost;
  watched = own;
}

void Answers::add(const Answers& others, double perfect) {
  for (const auto& [cost, own] : others.few) add(cost, own, perfect);
  if (others.watched_cost >= 0) watch(others.watched_cost, others.watched);
}

SearchShare::SearchShare(const MatchProblem& problem, const std::vector<Component>& components,
                         const SearchSamples& samples, ShareTask task)
    : problem_(problem),
      components_(components),
      samples_(samples),
      task_(std::move(task)),
      seeds_(task_.seed) {
  next();
}

/// Begins the next component that is not perfect yet.
void SearchShare::next() {
  if (moves_) {
    spent_ += moves_->spent();
    ++current_;
  }
  moves_.reset();
  share_ = 0;
  for (; current_ < components_.size(); ++current_) {
    const std::uint64_t seed = seeds_.bits();
    if (task_.known[current_].isPerfect(SearchMoves::perfect(samples_))) continue;
    moves_.emplace(problem_, samples_, seed, task_.slack);
    starts_ = idle_ = hits_ = 0;
    const Component& c = components_[current_];
    const double pieces = static_cast<double>(c.leaders.size());
    allowed_ = allowedIn(c, task_.budget);
    patience_ = task_.budget.idle * (pieces + SearchTuning::kPatiencePieces) * patienceFor(pieces);
    return;
  }
}

void SearchShare::keep(const Component& c, const Layout& layout, double cost) {
  Answers& answers = task_.known[current_];
  Alignments own;
  for (int l : c.leaders) own.push_back(layout.at[l]);
  if (task_.watched > 0) answers.watch(moves_->costOf(c, layout, task_.watched), own);
  const double known = answers.cost();
  answers.add(cost, own, moves_->perfect());
  const bool gained = known < 0 || cost <= known - SearchTuning::kGain * known;
  idle_ = gained ? 0 : idle_ + 1;
}

/// The answer that a step continues from: the best or, now and then, another good one.
Alignments SearchShare::startFrom(const Component& c, bool anew) {
  Alignments at = task_.at;
  const auto& few = task_.known[current_].few;
  if (few.empty()) return at;
  const bool other = !anew && moves_->uniform() < SearchTuning::kOtherAnswer;
  const Alignments& own = few[other ? moves_->below(static_cast<int>(few.size())) : 0].second;
  for (std::size_t i = 0; i < own.size(); ++i) at[c.leaders[i]] = own[i];
  return at;
}

/// Places the `fresh` leaders of a part again.
void SearchShare::lay(const Component& part, bool anew, const std::vector<char>& fresh,
                      Layout& layout) {
  std::vector<char> placed(fresh.size());
  // The very first answer is shown, so it is grown.
  const bool grown =
      task_.known[current_].few.empty() ||
      moves_->uniform() >= (anew ? SearchTuning::kScattered : SearchTuning::kDetached);
  if (!grown && anew) {
    for (int l : part.leaders) moves_->layAnywhere(l, layout);
    return;
  }
  if (grown) {
    for (std::size_t l = 0; l < placed.size(); ++l) placed[l] = !fresh[l];
  } else {
    moves_->layAnywhere(part.leaders[0], layout);
    placed[part.leaders[0]] = 1;
  }
  moves_->grow(part, layout, placed);
}

bool SearchShare::step() {
  if (!moves_) return false;
  const Component& c = components_[current_];
  const Answers& answers = task_.known[current_];
  const SearchBudget& budget = task_.budget;
  const bool anew =
      starts_ < budget.trees || moves_->uniform() < freshShare(static_cast<int>(c.leaders.size()));
  Layout layout = moves_->layoutOf(startFrom(c, anew));
  Component part = c;
  if (anew)
    ++starts_;
  else
    part.leaders = moves_->randomPart(c);
  std::vector<char> fresh(problem_.leaders.size(), 0);
  for (int l : part.leaders) fresh[l] = 1;
  lay(part, anew, fresh, layout);
  const double known = answers.cost(), cost = moves_->improve(c, layout, fresh, known);
  keep(c, layout, cost);
  const double best = answers.cost();
  if (known < 0 || best < known * (1 - SearchTuning::kSameAnswer)) hits_ = 0;
  if (anew && cost < best * (1 + SearchTuning::kSameAnswer)) ++hits_;
  const double spent = moves_->spent();
  const bool enough = starts_ >= budget.trees && (hits_ >= budget.hits || idle_ >= patience_);
  share_ = std::max(share_, std::min(1.0, std::max(spent / allowed_, idle_ / patience_)));
  if (answers.isPerfect(moves_->perfect()) || enough || spent > allowed_) next();
  return moves_.has_value();
}

double SearchShare::fraction() const {
  if (!moves_) return 1;
  return (static_cast<double>(current_) + share_) / static_cast<double>(components_.size());
}

double SearchShare::spent() const { return spent_ + (moves_ ? moves_->spent() : 0); }

}  // namespace seamwise
