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
#include "tuning/progress.h"

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

/// Memo of this module between solves, since a page changes one thing at a time.
inline SolveMemo memo;

/// JavaScript handle of a solve, which reads its problem, then sets it up, then runs. Every call
/// after a failure is harmless and does nothing.
class SolverHandle {
 public:
  explicit SolverHandle(const val& problem) : reader_(problemTexts(problem)) {}

  val failure() const { return failureValue(error_); }

  bool advance(int steps) {
    for (; !error_ && !solver_ && steps > 0; --steps) prepare();
    if (solver_ && steps > 0) return solver_->advance(steps);
    return !error_;
  }

  std::string phase() const {
    if (!solver_) return "preparation";
    return solver_->phase() >= Phase::kDeformation ? "deformation" : "alignment";
  }

  int attempt() const { return solver_ ? solver_->attempt() : 0; }

  double fraction() const {
    if (solver_) return solver_->fraction();
    const double read = reader_ ? reader_->fraction() : 1, set_up = setup_ ? setup_->fraction() : 0;
    return ProgressTuning::kPrepared *
           (ProgressTuning::kReading * read + (1 - ProgressTuning::kReading) * set_up);
  }

  val partial() const {
    std::vector<double> flat;
    if (solver_)
      for (const Alignment& alignment : solver_->partial()) {
        flat.push_back(alignment.angle);
        flat.push_back(alignment.translation.x());
        flat.push_back(alignment.translation.y());
      }
    return copied(flat);
  }

  /// Returns a share of the current search for another thread, and its number; null when there is
  /// none.
  val lend() {
    AlignmentSearch* const search = solver_ ? solver_->searching() : nullptr;
    std::shared_ptr<AlignmentSearch::Share> share = search ? search->lend() : nullptr;
    if (!share) return val::null();
    val lent = val::object();
    lent.set("number", static_cast<int>(lent_.size()));
    lent.set("order", copied(writeShare(search->problem(), share->task)));
    lent_.push_back({share, componentsOf(search->problem())});
    return lent;
  }

  /// Returns whether the answers of a lent share are still missing.
  bool awaits(int number) const {
    const auto share = lent_[static_cast<std::size_t>(number)].share.lock();
    return share && !share->answers;
  }

  /// Takes the answers of a lent share. Those for a search that has ended have no effect.
  void take(int number, const val& answers) {
    const Lent& lent = lent_[static_cast<std::size_t>(number)];
    if (const auto share = lent.share.lock())
      share->answers =
          readAnswers(emscripten::convertJSArrayToNumberVector<double>(answers), lent.components);
  }

  /// The meshed garment before the solve; empty before the preparation has ended.
  val pattern() const {
    return copied(solver_ ? writePattern(solver_->unsolved()) : std::string());
  }

  val result() {
    while (!error_ && !solver_) prepare();
    if (error_) return copied(std::string());
    const Outcome<Result> finished = solver_->finish();
    if (finished.ok()) return copied(writeResult(finished.value()));
    fail(finished.error());
    return copied(std::string());
  }

  bool prove(int steps) { return solver_ && solver_->prove(steps); }

  val proven() const {
    const Proven proven = solver_ ? solver_->proven() : Proven{};
    val answer = val::object();
    answer.set("bound", proven.bound);
    answer.set("searchCost", proven.search_cost);
    return answer;
  }

 private:
  /// Takes one step of the preparation.
  void prepare() {
    if (reader_) {
      if (reader_->advance()) return;
      Outcome<Problem> problem = reader_->take();
      reader_.reset();
      if (!problem.ok()) return fail(problem.error());
      setup_.emplace(std::move(problem).value(), &memo);
    } else if (!setup_->advance()) {
      Outcome<Solver> solver = setup_->take();
      setup_.reset();
      if (!solver.ok()) return fail(solver.error());
      solver_.emplace(std::move(solver).value());
    }
  }

  void fail(const Error& error) {
    error_ = error;
    solver_.reset();
  }

  struct Lent {
    std::weak_ptr<AlignmentSearch::Share> share;
    std::vector<Component> components;
  };

  std::optional<ProblemReader> reader_;
  std::optional<SolverSetup> setup_;
  std::optional<Solver> solver_;
  std::optional<Error> error_;
  std::vector<Lent> lent_;  ///< the index is the share's number
};

}  // namespace seamwise
