#include "solve/prepare_symmetric.h"

#include <algorithm>
#include <utility>

#include "pattern/seam_measure.h"
#include "solve/reconcile.h"

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

Outcome<PreparedPatterns> preparedPatterns(Problem& problem, MeshMemo& memo) {
  const Symmetries carried = carriedSymmetries(problem);
  if (problem.options.method == Method::kBest && carried.size() > problem.imposed.size()) {
    Problem more = problem;
    more.imposed = carried;
    more.symmetries_optional = true;
    const Outcome<Pattern> symmetric = preparedPattern(more, &memo);
    if (symmetric.ok() && more.imposed.size() > problem.imposed.size() &&
        std::all_of(problem.imposed.begin(), problem.imposed.end(),
                    [&](const BodySymmetry& s) { return contains(more.imposed, s); }))
      return PreparedPatterns{freed(symmetric.value(), more.imposed, problem.imposed),
                              symmetric.value(), symmetric.value().mirrors};
  }
  Outcome<Pattern> asked = preparedPattern(problem, &memo);
  if (!asked.ok()) return asked.error();
  PreparedPatterns prepared{std::move(asked).value(), {}, {}};
  if (problem.imposed.empty())
    for (const BodySymmetry& s : carriedSymmetries(problem))
      prepared.known.push_back({{s.pieces[0], s.pieces[1]}, s.map, {}});
  return prepared;
}

}  // namespace seamwise
