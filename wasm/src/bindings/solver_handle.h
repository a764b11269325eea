#pragma once
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bindings/values.h"
#include "io/problem_json.h"
#include "io/result_json.h"
#include "io/share_numbers.h"
#include "solve/solver.h"

namespace seamwise {

inline ProblemTexts problemTexts(const val& problem) {
  const auto text = [&](const char* field) { return problem[field].as<std::string>(); };
  ProblemTexts texts;
  texts.garment = text("garment");
  texts.garment_name = text("garmentName");
  texts.print = text("print");
  texts.print_name = text("printName");
  texts.symmetry = text("symmetry");
  texts.symmetry_name = text("symmetryName");
  texts.options = text("options");
  texts.options_name = text("optionsName");
  const std::string method = text("method");
  texts.method = method == "paper"  ? Method::kPaper
                 : method == "ws19" ? Method::kWs19
                                    : Method::kBest;
  texts.seed = problem["seed"].as<std::uint32_t>();
  return texts;
}

/// A page changes one thing at a time, and its worker solves again with the same module.
inline SolveMemo memo;

/// Of the time until a garment is ready to be solved, as a rule.
inline constexpr double kReadingPart = 0.7;

/// A solve as JavaScript holds it: first its problem is read, then it is set up, then it runs.
/// After a failure every call is harmless and does nothing.
class SolverHandle {
 public:
  explicit SolverHandle(const val& problem) {
    guard([&]() -> std::optional<Error> {
      reader_.emplace(problemTexts(problem));
      return std::nullopt;
    });
  }

  val failure() const { return failureValue(error_); }

  bool advance(int steps) {
    bool more = false;
    guard([&] {
      for (more = true; more && steps > 0 && !solver_; --steps)
        if (auto error = prepare()) return error;
      if (solver_ && steps > 0) more = solver_->advance(steps);
      return std::optional<Error>();
    });
    return more && !error_;
  }

  std::string phase() const {
    if (!solver_) return "preparation";
    return solver_->phase() >= Phase::kDeformation ? "deformation" : "alignment";
  }

  int attempt() const { return solver_ ? solver_->attempt() : 0; }

  double fraction() const {
    if (solver_) return solver_->fraction();
    const double read = reader_ ? reader_->fraction() : 1, set_up = setup_ ? setup_->fraction() : 0;
    return kPrepared * (kReadingPart * read + (1 - kReadingPart) * set_up);
  }

  val partial() {
    std::vector<double> flat;
    guard([&]() -> std::optional<Error> {
      if (!solver_) return std::nullopt;
      for (const Alignment& alignment : solver_->partial()) {
        flat.push_back(alignment.angle);
        flat.push_back(alignment.translation.x());
        flat.push_back(alignment.translation.y());
      }
      return std::nullopt;
    });
    return copied(flat);
  }

  /// A share of the present search for another thread, and its number; null when there is none.
  val lend() {
    val lent = val::null();
    guard([&]() -> std::optional<Error> {
      AlignmentSearch* const search = solver_ ? solver_->searching() : nullptr;
      std::shared_ptr<AlignmentSearch::Share> share = search ? search->lend() : nullptr;
      if (!share) return std::nullopt;
      lent = val::object();
      lent.set("number", static_cast<int>(lent_.size()));
      lent.set("order", copied(writeShare(search->problem(), share->task)));
      lent_.push_back({share, componentsOf(search->problem())});
      return std::nullopt;
    });
    return lent;
  }

  /// Whether a share that was lent is still waited for.
  bool awaits(int number) const {
    const auto share = lent_[static_cast<std::size_t>(number)].share.lock();
    return share && !share->answers;
  }

  /// The answers of a share that was lent. Those of a search that has ended are of no use.
  void take(int number, const val& answers) {
    guard([&]() -> std::optional<Error> {
      const Lent& lent = lent_.at(static_cast<std::size_t>(number));
      if (const auto share = lent.share.lock())
        share->answers =
            readAnswers(emscripten::convertJSArrayToNumberVector<double>(answers), lent.components);
      return std::nullopt;
    });
  }

  /// The garment as it is meshed, not solved; empty before the preparation has ended.
  val pattern() {
    std::string bytes;
    guard([&]() -> std::optional<Error> {
      if (solver_) bytes = writePattern(solver_->unsolved());
      return std::nullopt;
    });
    return copied(bytes);
  }

  val result() {
    std::string bytes;
    guard([&]() -> std::optional<Error> {
      while (!solver_)
        if (auto error = prepare()) return error;
      const Outcome<Result> finished = solver_->finish();
      if (!finished.ok()) return finished.error();
      bytes = writeResult(finished.value());
      return std::nullopt;
    });
    return copied(bytes);
  }

  bool prove(int steps) {
    bool more = false;
    guard([&]() -> std::optional<Error> {
      if (solver_) more = solver_->prove(steps);
      return std::nullopt;
    });
    return more;
  }

  val proven() const {
    const Proven proven = solver_ ? solver_->proven() : Proven{};
    val answer = val::object();
    answer.set("bound", proven.bound);
    answer.set("fitSearch", proven.fit_search);
    return answer;
  }

 private:
  /// One step of what comes before the solve.
  std::optional<Error> prepare() {
    if (reader_) {
      if (reader_->advance()) return std::nullopt;
      Outcome<Problem> problem = reader_->take();
      reader_.reset();
      if (!problem.ok()) return problem.error();
      setup_.emplace(std::move(problem).value(), &memo);
    } else if (!setup_->advance()) {
      Outcome<Solver> solver = setup_->take();
      setup_.reset();
      if (!solver.ok()) return solver.error();
      solver_.emplace(std::move(solver).value());
    }
    return std::nullopt;
  }

  struct Lent {
    std::weak_ptr<AlignmentSearch::Share> share;
    std::vector<Component> components;
  };

  template <class Work>
  void guard(Work work) {
    if (!error_) error_ = caught(std::move(work));
    if (!error_) return;
    reader_.reset();
    setup_.reset();
    solver_.reset();
  }

  std::optional<ProblemReader> reader_;
  std::optional<SolverSetup> setup_;
  std::optional<Solver> solver_;
  std::optional<Error> error_;
  std::vector<Lent> lent_;  ///< by number
};

}  // namespace seamwise
