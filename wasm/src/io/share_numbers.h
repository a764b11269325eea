#pragma once
#include <optional>
#include <vector>

#include "alignment/search/search_share.h"

namespace seamwise {

/// A share of a search. It and its answers are exchanged as plain numbers with workers that share
/// no memory. The values read equal the values written to the last bit. The same build must read
/// and write them.
struct ShareOrder {
  MatchProblem problem;  ///< lacks its pieces, which a search does not use
  ShareTask task;
};
std::vector<double> writeShare(const MatchProblem& problem, const ShareTask& task);
/// Empty for numbers that are no share.
std::optional<ShareOrder> readShare(const std::vector<double>& numbers);

std::vector<double> writeAnswers(const std::vector<Answers>& answers);
/// Empty for numbers that are no answers or belong to other components.
std::optional<std::vector<Answers>> readAnswers(const std::vector<double>& numbers,
                                                const std::vector<Component>& components);

}  // namespace seamwise
