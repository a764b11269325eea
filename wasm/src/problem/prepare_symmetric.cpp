#include "problem/prepare_symmetric.h"

#include <algorithm>
#include <utility>

#include "pattern/seam_measure.h"
#include "problem/reconcile.h"
#include "tuning/progress.h"

namespace seamwise {
namespace {

using Symmetries = std::vector<BodySymmetry>;

/// The imposed symmetries, then the other known ones that the print's group carries.
Symmetries carriedSymmetries(const GarmentSymmetries& symmetries, const WallpaperGroup& group) {
  Symmetries carried = symmetries.imposed;
  for (const BodySymmetry& s : symmetries.known)
    if (!contains(carried, s) && (s.single() ? group.carriesSingle() : group.carriesPair()))
      carried.push_back(s);
  return carried;
}

/// Reduces the mirrors of a symmetric pattern to the requested ones.
/// @param imposed   symmetries of the pattern, in the order of its mirrors
Pattern freedPattern(Pattern pattern, const Symmetries& imposed, const Symmetries& asked) {
  std::vector<Mirror> kept;
  for (std::size_t m = 0; m < imposed.size(); ++m)
    if (contains(asked, imposed[m])) kept.push_back(std::move(pattern.mirrors[m]));
  pattern.mirrors = std::move(kept);
  setLengthRatios(pattern);
  return pattern;
}

}  // namespace

SymmetricPreparation::SymmetricPreparation(const Problem& problem, MeshMemo* memo)
    : problem_(problem), memo_(memo) {
  GarmentSymmetries symmetries = problem.symmetries;
  if (problem.options.method == Method::kBest) {
    Symmetries carried = carriedSymmetries(symmetries, problem.print.group);
    has_more_ = carried.size() > symmetries.imposed.size();
    if (has_more_) symmetries = {std::move(carried), std::move(symmetries.known), true};
  }
  preparation_.emplace(problem, std::move(symmetries), memo);
}

bool SymmetricPreparation::advance() {
  if (symmetric_) return false;
  const bool more = preparation_->advance();
  fraction_ = std::max(fraction_,
                       (has_more_ ? ProgressTuning::kMoreSymmetry : 1) * preparation_->fraction());
  return more || (has_more_ && judge());
}

/// Accepts the mesh if more symmetries than the requested ones hold. Otherwise restarts with the
/// requested ones and returns true.
bool SymmetricPreparation::judge() {
  Outcome<Prepared> made = preparation_->take();
  if (made.ok()) {
    Prepared& more = made.value();
    const Symmetries &left = more.symmetries.imposed, &asked = problem_.symmetries.imposed;
    if (left.size() > asked.size() &&
        std::all_of(asked.begin(), asked.end(),
                    [&](const BodySymmetry& s) { return contains(left, s); })) {
      std::vector<Mirror> known = more.pattern.mirrors;
      Pattern freed = freedPattern(more.pattern, left, asked);
      symmetric_ = {{std::move(freed), problem_.symmetries, {}, std::move(more.plans)},
                    std::move(more.pattern),
                    std::move(known)};
      return false;
    }
  }
  has_more_ = false;
  preparation_.emplace(problem_, problem_.symmetries, memo_);
  return true;
}

Outcome<PreparedProblem> SymmetricPreparation::take() {
  if (symmetric_) return *std::move(symmetric_);
  Outcome<Prepared> asked = preparation_->take();
  if (!asked.ok()) return asked.error();
  PreparedProblem prepared{std::move(asked).value(), {}, {}};
  const GarmentSymmetries& left = prepared.asked.symmetries;
  if (left.imposed.empty())
    for (const BodySymmetry& s : carriedSymmetries(left, problem_.print.group))
      prepared.known.push_back({{s.pieces[0], s.pieces[1]}, s.map, {}});
  return prepared;
}

}  // namespace seamwise
