#include "alignment/search/search_memo.h"

#include <algorithm>

namespace seamwise {
namespace {

constexpr std::size_t kKeptSearches = 10;  ///< a change and its undoing, with five searches each

}  // namespace

const SearchMemo::Outcome* SearchMemo::find(const Inputs& inputs) const {
  const auto known = std::find_if(kept_.begin(), kept_.end(),
                                  [&](const auto& entry) { return entry.first == inputs; });
  return known == kept_.end() ? nullptr : &known->second;
}

void SearchMemo::add(Inputs inputs, Outcome outcome) {
  if (kept_.size() == kKeptSearches) kept_.erase(kept_.begin());
  kept_.emplace_back(std::move(inputs), std::move(outcome));
}

}  // namespace seamwise
