#include "methods/search_stage.h"

#include <algorithm>
#include <cmath>

#include "methods/drafted.h"
#include "methods/seam_rules.h"
#include "tuning/progress.h"
#include "tuning/search.h"
#include "tuning/shaping.h"

namespace seamwise {
namespace {

SearchBudget withProof(SearchBudget budget, std::optional<double> proof) {
  budget.proof = proof;
  return budget;
}

/// The same print with w1 along the x-axis, rounded to about eight digits, so that the print's turn
/// has no effect.
WallpaperGroup straightened(const WallpaperGroup& group) {
  const Mat2 back = rotation(-directionOf(group.w1()));
  const double unit = std::ldexp(1.0, std::ilogb(group.w1().norm()) - 24);
  const auto rounded = [&](const Vec2& w) {
    const Vec2 turned = back * w;
    return Vec2(std::round(turned.x() / unit) * unit + 0.0,
                std::round(turned.y() / unit) * unit + 0.0);  // never a negative zero
  };
  auto straight = WallpaperGroup::make(group.data().name, rounded(group.w1()), rounded(group.w2()));
  return straight.ok() ? std::move(straight).value() : group;
}

/// The pattern with the weights of its file.
Pattern asDrafted(const Problem& problem, Pattern pattern) {
  for (const auto& [seam, weight] : problem.options.weights)
    pattern.seams[seam].weight = problem.garment.stitches[seam].weight;
  return pattern;
}

}  // namespace

SearchStage::SearchStage(const Problem& problem, const Pattern& pattern, const MatchProblem& match,
                         const std::vector<Mirror>& known, const MatchRules& rules, double slack,
                         std::vector<Alignments> offered, SearchMemo& memo)
    : problem_(problem), match_(match), slack_(slack), offered_(std::move(offered)), memo_(memo) {
  const WallpaperGroup& group = match.group;
  const std::uint64_t seed = problem.options.seed;
  const std::optional<double> proof = problem.options.proof;
  MatchRules unpinned = rules;
  for (PieceRule& rule : unpinned.pieces) rule.pin.reset();
  const bool turns = std::all_of(rules.pieces.begin(), rules.pieces.end(),
                                 [](const PieceRule& rule) { return rule.angles.empty(); });
  const WallpaperGroup straight = turns ? straightened(group) : group;
  const double turn = turns ? directionOf(group.w1()) : 0;
  Pattern reweighted;
  const Pattern& drafted =
      problem.options.weights.empty() ? pattern : (reweighted = asDrafted(problem, pattern));
  const auto plainProblem = [&](const std::vector<Mirror>& mirrors) {
    return makeMatchProblem(drafted, restShapes(drafted), mirrors, unpinned, straight);
  };

  const bool guided = known.size() > pattern.mirrors.size();
  const ProgressTuning::Searches& parts =
      guided ? ProgressTuning::kGuided : ProgressTuning::kUnguided;
  if (guided)
    searches_.push_back(
        {plainProblem(known), withProof({}, proof), seed, parts.guide, {}, 0, turn});
  const std::size_t plain = searches_.size();
  searches_.push_back(
      {plainProblem(pattern.mirrors), withProof({}, proof), seed, parts.rest, {}, 0, turn});
  if (guided) searches_[plain].after = {0};
  searches_.push_back({searches_[plain].problem,
                       SearchTuning::kUnderSlack,
                       seed + 1,
                       parts.slack,
                       {plain},
                       slack,
                       turn});
  if (searches_[plain].problem != match) {
    const bool turned_only = problem.options.weights.empty() && problem.options.pins.empty();
    const SearchBudget budget =
        withProof(turned_only ? SearchTuning::kTouchUp : SearchTuning::kNearby, proof);
    const double part = turned_only ? ProgressTuning::kTouchUp : ProgressTuning::kNearby;
    searches_.push_back({match, budget, seed, part, {plain}});
    searches_.push_back({match, budget, seed + 1, part, {plain + 2, plain + 1}, slack});
  }
  const auto rest = std::find_if(searches_.rbegin(), searches_.rend(),
                                 [](const Search& search) { return search.slack == 0; });
  rest->requested = true;
  share_ = ProgressTuning::searches(static_cast<double>(match.leaders.size()), group.data().order);
  double whole = 0;
  for (const Search& search : searches_) whole += search.share;
  for (Search& search : searches_) search.share *= share_ / whole;
  best_ = match.ofLeaders(Alignments(pattern.pieces.size()));
  under_slack_ = {best_};
}

/// Alignments of all pieces on the print as given, from those of a search's leaders.
Alignments SearchStage::placed(const Search& search, const Alignments& leaders) const {
  Alignments pieces = search.problem.expanded(leaders);
  for (Alignment& at : pieces) at.angle -= search.turn;
  return pieces;
}

/// Limits the mismatch of seams under slack to that of placing alone.
void SearchStage::limit(Search& search) const {
  const Alignments placed = search.problem.ofLeaders(found_[search.after[0]][0]);
  const SampledSeams<double> edges(search.problem, 0);
  for (std::size_t s = 0; s < search.problem.seams.size(); ++s) {
    MatchSeam& seam = search.problem.seams[s];
    if (seam.seam < 0) continue;
    const double mean = edges.cost(static_cast<int>(s), edges.pose(seam.a, placed[seam.a]),
                                   edges.pose(seam.b, placed[seam.b]), 0) /
                        seam.weight;
    const Stitch& stitch = problem_.garment.stitches[static_cast<std::size_t>(seam.seam)];
    seam.limit = ShapingTuning::kLimitShare * greatestMean(mean, stitch.visibility);
  }
}

void SearchStage::begin() {
  Search& search = searches_[current_];
  if (search.slack > 0) limit(search);
  std::vector<Alignments> offered;
  const auto offer = [&](Alignments pieces, double turn) {
    if (turn != 0)
      for (Alignment& at : pieces) at.angle += turn;
    offered.push_back(search.problem.ofLeaders(pieces));
  };
  for (const std::size_t before : search.after)
    for (const Alignments& pieces : found_[before])
      offer(pieces, search.turn - searches_[before].turn);
  if (search.slack == 0)
    offered.push_back(search.problem.ofLeaders(draftedLayout(problem_, search.problem)));
  if (search.requested)
    for (const Alignments& pieces : offered_) offer(pieces, search.turn);
  if (search.slack > 0 && search.problem.cost(offered[0]) < SearchTuning::kPerfectCost) {
    share_ -= search.share;
    return end({{offered[0]}, offered[0], 0});  // no shape has to change
  }
  const double watched = search.slack > 0 ? 0 : slack_;
  inputs_ = {search.problem, search.budget, search.seed, search.slack, watched, offered};
  if (const SearchMemo::Outcome* known = memo_.find(*inputs_)) {
    share_ -= search.share;
    return end(*known);
  }
  searching_ =
      std::make_unique<AlignmentSearch>(search.problem, search.seed, search.budget, search.slack);
  searching_->watch(watched);
  for (const Alignments& leaders : offered) searching_->offer(leaders);
}

void SearchStage::end(const SearchMemo::Outcome& outcome) {
  const Search& search = searches_[current_];
  found_.push_back(
      {search.problem.expanded(outcome.few[0]), search.problem.expanded(outcome.watched)});
  under_slack_.clear();
  for (const Alignments& leaders : outcome.few)
    under_slack_.push_back(match_.ofLeaders(placed(search, leaders)));
  ++current_;
  if (search.slack > 0) return;
  at_rest_ = current_ - 1;
  few_at_rest_ = under_slack_;
  best_ = few_at_rest_[0];
  bound_ = outcome.bound;
  perfect_ = match_.cost(best_) < SearchTuning::kPerfectCost;
}

void SearchStage::seekAgain(const std::vector<double>& factors) {
  const Search& last = searches_.back();
  Search next{last.problem,
              SearchTuning::kUnderSlack,
              last.seed + 1,
              0,
              {at_rest_, searches_.size() - 1},
              slack_,
              last.turn};
  for (MatchSeam& seam : next.problem.seams) {
    if (seam.seam < 0) continue;
    const double factor = factors[static_cast<std::size_t>(seam.seam)];
    for (double& w : seam.w) w *= factor;
    seam.weight *= factor;
    seam.whole = seam.stretch(0, seam.w.size());
  }
  searches_.push_back(std::move(next));
}

bool SearchStage::advance() {
  if (current_ == searches_.size()) return false;
  if (!searching_) begin();
  if (searching_) {
    const Search& search = searches_[current_];
    const double until = searching_->spent() + SearchTuning::kStepWork;
    bool more = true;
    while (more && searching_->spent() < until) more = searching_->step();
    if (search.slack == 0) best_ = match_.ofLeaders(placed(search, searching_->best()));
    fraction_ = std::max(fraction_, (before_ + search.share * searching_->fraction()) / share_);
    if (!more) {
      before_ += search.share;
      SearchMemo::Outcome outcome{searching_->bestFew(), searching_->watched(),
                                  searching_->bound()};
      searching_.reset();
      end(outcome);
      memo_.add(std::move(*inputs_), std::move(outcome));
    }
  }
  return current_ < searches_.size();
}

}  // namespace seamwise
