#include "problem/prepare_symmetric.h"

#include <algorithm>
#include <utility>

#include "pattern/seam_measure.h"
#include "problem/reconcile.h"
#include "tuning/progress.h"

namespace seamwise {
namespace {

using Symmetries = std::vector<BodySymmetry>;

/// Those that are imposed, then the known ones that the print's group carries besides.
Symmetries carriedSymmetries(const Problem& problem) {
  Symmetries carried = problem.imposed;
  const WallpaperGroup& group = problem.print.group;
  for (const BodySymmetry& s : problem.known)
    if (!contains(carried, s) && (s.single() ? group.carriesSingle() : group.carriesPair()))
      carried.push_back(s);
  return carried;
}

/// The symmetric pattern with only those of its mirrors that are asked for.
/// @param imposed   of the symmetric pattern, in the order of its mirrors
Pattern freed(Pattern pattern, const Symmetries& imposed, const Symmetries& asked) {
  std::vector<Mirror> kept;
  for (std::size_t m = 0; m < imposed.size(); ++m)
    if (contains(asked, imposed[m])) kept.push_back(std::move(pattern.mirrors[m]));
  pattern.mirrors = std::move(kept);
  measureSeams(pattern);
  return pattern;
}

}  // namespace

SymmetricPreparation::SymmetricPreparation(Problem& problem, MeshMemo* memo)
    : problem_(problem), memo_(memo) {
  Symmetries carried = carriedSymmetries(problem);
  if (problem.options.method == Method::kBest && carried.size() > problem.imposed.size()) {
    more_ = problem;
    more_->imposed = std::move(carried);
    more_->symmetries_optional = true;
  }
  preparation_.emplace(more_ ? *more_ : problem, memo);
}

bool SymmetricPreparation::advance() {
  if (symmetric_) return false;
  const bool more = preparation_->advance();
  fraction_ =
      std::max(fraction_, (more_ ? ProgressTuning::kMoreSymmetry : 1) * preparation_->fraction());
  return more || (more_ && judge());
}

/// Whether to begin anew, without more symmetries than are asked for.
bool SymmetricPreparation::judge() {
  const Symmetries &left = more_->imposed, &asked = problem_.imposed;
  const Outcome<Pattern> pattern = preparation_->take();
  if (pattern.ok() && left.size() > asked.size() &&
      std::all_of(asked.begin(), asked.end(),
                  [&](const BodySymmetry& s) { return contains(left, s); })) {
    symmetric_ = {freed(pattern.value(), left, asked), pattern.value(), pattern.value().mirrors};
    return false;
  }
  more_.reset();
  preparation_.emplace(problem_, memo_);
  return true;
}

Outcome<PreparedPatterns> SymmetricPreparation::take() {
  if (symmetric_) return *std::move(symmetric_);
  Outcome<Pattern> asked = preparation_->take();
  if (!asked.ok()) return asked.error();
  PreparedPatterns prepared{std::move(asked).value(), {}, {}};
  if (problem_.imposed.empty())
    for (const BodySymmetry& s : carriedSymmetries(problem_))
      prepared.known.push_back({{s.pieces[0], s.pieces[1]}, s.map, {}});
  return prepared;
}

}  // namespace seamwise
