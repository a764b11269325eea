#include "methods/run_memo.h"

#include <utility>

namespace seamwise {

RunInputs::RunInputs(const Problem& problem, const Pattern& pattern, MatchProblem match_problem,
                     std::size_t guided, const std::vector<Alignments>& offered,
                     const std::vector<Alignments>& starts)
    : garment(problem.garment),
      rest(restShapes(pattern)),
      match(std::move(match_problem)),
      alignments(offered) {
  alignments.insert(alignments.end(), starts.begin(), starts.end());
  const SolveOptions& options = problem.options;
  const double average = options.average_seam_shapes ? *options.average_seam_shapes : -1;
  settings = {double(options.seed),
              options.max_change_cm,
              options.alpha.value_or(-1),
              average,
              double(options.open_edges),
              double(options.visibility),
              options.proof.value_or(-1),
              double(options.pins.size()),
              double(guided),
              double(offered.size()),
              double(options.weights.size())};
  for (const auto& [seam, weight] : options.weights)
    settings.insert(settings.end(), {double(seam), weight});
  for (const EdgeRef& edge : options.locked)
    settings.insert(settings.end(), {double(edge.piece), double(edge.edge)});
}

}  // namespace seamwise
