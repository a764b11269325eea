#pragma once
#include <optional>
#include <vector>

#include "alignment/search/search_share.h"

namespace seamwise {

/// A share of a search and its answers as plain numbers, to be handed to where no memory is in
/// common and back. What is read equals what was written to the last bit; it is read by the same
/// build that wrote it.
struct ShareOrder {
  MatchProblem problem;  ///< without its pieces, of which a search knows nothing
  ShareTask task;
};
std::vector<double> writeShare(const MatchProblem& problem, const ShareTask& task);
/// Empty when it is none.
std::optional<ShareOrder> readShare(const std::vector<double>& numbers);

std::vector<double> writeAnswers(const std::vector<Answers>& answers);
/// Empty when they are none, or not of these components.
std::optional<std::vector<Answers>> readAnswers(const std::vector<double>& numbers,
                                                const std::vector<Component>& components);

}  // namespace seamwise
