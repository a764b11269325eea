#pragma once
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "bindings/values.h"
#include "io/share_numbers.h"

namespace seamwise {

/// JavaScript handle of a search's share that runs on another thread.
class ShareHandle {
 public:
  explicit ShareHandle(const val& numbers) {
    auto order = readShare(emscripten::convertJSArrayToNumberVector<double>(numbers));
    if (order)
      work_ = std::make_unique<Work>(*std::move(order));
    else
      error_ = Error{Failure::kInternal, "A share of a search came damaged."};
  }

  val failure() const { return failureValue(error_); }

  bool advance(int steps) {
    bool more = work_ != nullptr;
    for (; more && steps > 0; --steps) more = work_->share.step();
    return more;
  }

  /// The answers, once nothing remains to be done.
  val answers() const {
    return copied(work_ ? writeAnswers(work_->share.answers()) : std::vector<double>());
  }

 private:
  struct Work {
    explicit Work(ShareOrder of)
        : order(std::move(of)),
          components(componentsOf(order.problem)),
          samples(searchSamples(order.problem, order.task.budget)),
          share(order.problem, components, samples, order.task) {}
    ShareOrder order;
    std::vector<Component> components;
    SearchSamples samples;
    SearchShare share;
  };
  std::unique_ptr<Work> work_;
  std::optional<Error> error_;
};

}  // namespace seamwise
