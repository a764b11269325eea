#pragma once
#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace seamwise {

/// The outcomes of the last few computations by their inputs. The inputs are everything that an
/// outcome depends on, so results are the same with or without a memo.
template <class In, class Out, std::size_t kMost>
class Memo {
 public:
  using Inputs = In;
  using Outcome = Out;

  /// Returns null if there was no such computation lately.
  const Outcome* find(const Inputs& inputs) const {
    const auto known = std::find_if(kept_.begin(), kept_.end(),
                                    [&](const auto& entry) { return entry.first == inputs; });
    return known == kept_.end() ? nullptr : &known->second;
  }

  void add(Inputs inputs, Outcome outcome) {
    if (kept_.size() == kMost) kept_.erase(kept_.begin());
    kept_.emplace_back(std::move(inputs), std::move(outcome));
  }

 private:
  std::vector<std::pair<Inputs, Outcome>> kept_;  ///< the oldest first
};

}  // namespace seamwise
