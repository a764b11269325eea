// The WebAssembly module's face to JavaScript; web/src/solver/module/seamwise.d.mts describes it.
// Nothing but plain values crosses, JSON documents among them as bytes (json_bytes.cpp), and no
// exception does: what goes wrong is kept as a failure that JavaScript asks for.
#include <emscripten/bind.h>
#include <emscripten/heap.h>
#include <malloc.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bindings/share_handle.h"
#include "bindings/values.h"
#include "io/garment_json.h"
#include "io/json_ends.h"
#include "io/problem_json.h"
#include "io/result_json.h"
#include "io/share_numbers.h"
#include "io/symmetry_json.h"
#include "solve/solver.h"

namespace seamwise {
namespace {

/// `make` gives an Outcome<std::string>; the document, or why there is none.
template <class Make>
val documentValue(Make make) {
  val answer = val::object();
  std::string bytes;
  const std::optional<Error> error = caught([&]() -> std::optional<Error> {
    Outcome<std::string> made = make();
    if (!made.ok()) return made.error();
    bytes = std::move(made).value();
    return std::nullopt;
  });
  answer.set("document", copied(bytes));
  answer.set("failure", failureValue(error));
  return answer;
}

ProblemTexts problemTexts(const val& problem) {
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
SolveMemo memo;

/// Of the time until a garment is ready to be solved, as a rule.
constexpr double kReadingPart = 0.7;

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
      for (more = true; more && steps > 0 && !solver_; --steps)
        if (auto error = prepare()) return error;
      if (solver_ && steps > 0) more = solver_->prove(steps);
      return std::nullopt;
    });
    return more && !error_;
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

/// The symmetries that a garment shows by itself, looked for in steps.
class DetectionHandle {
 public:
  DetectionHandle(const std::string& text, const std::string& name) {
    error_ = caught([&]() -> std::optional<Error> {
      Outcome<GarmentFile> file = readGarment(text, name);
      if (!file.ok()) return file.error();
      garment_ = std::move(file).value().garment;
      detection_.emplace(garment_);
      return std::nullopt;
    });
  }

  bool advance(int steps) {
    bool more = !error_;
    if (more)
      error_ = caught([&]() -> std::optional<Error> {
        for (; more && steps > 0; --steps) more = detection_->advance();
        return std::nullopt;
      });
    return more && !error_;
  }

  /// As a document, once advance() has returned false.
  val result() const {
    return documentValue([&]() -> Outcome<std::string> {
      if (error_) return *error_;
      return writeSymmetries(garment_, detection_->found());
    });
  }

 private:
  Garment garment_;
  std::optional<SymmetryDetection> detection_;
  std::optional<Error> error_;
};

val measuredSymmetries(const std::string& text, const std::string& name, const std::string& wanted,
                       const std::string& wanted_name) {
  return documentValue([&]() -> Outcome<std::string> {
    const Outcome<GarmentFile> file = readGarment(text, name);
    if (!file.ok()) return file.error();
    const auto requests = readSymmetries(wanted, wanted_name);
    if (!requests.ok()) return requests.error();
    const Garment& garment = file.value().garment;
    const auto measured = measureSymmetries(garment, requests.value());
    if (!measured.ok()) return inFile(measured.error(), wanted_name);
    return writeMeasured(garment, measured.value());
  });
}

val garmentFailure(const std::string& text, const std::string& name) {
  return failureValue(caught([&]() -> std::optional<Error> {
    const Outcome<GarmentFile> file = readGarment(text, name);
    if (!file.ok()) return file.error();
    return std::nullopt;
  }));
}

double liveBytes() { return static_cast<double>(static_cast<unsigned>(mallinfo().uordblks)); }
double heapBytes() { return static_cast<double>(emscripten_get_heap_size()); }

EMSCRIPTEN_BINDINGS(seamwise) {
  emscripten::class_<SolverHandle>("Solver")
      .constructor<const val&>()
      .function("failure", &SolverHandle::failure)
      .function("advance", &SolverHandle::advance)
      .function("phase", &SolverHandle::phase)
      .function("attempt", &SolverHandle::attempt)
      .function("fraction", &SolverHandle::fraction)
      .function("partial", &SolverHandle::partial)
      .function("lend", &SolverHandle::lend)
      .function("awaits", &SolverHandle::awaits)
      .function("take", &SolverHandle::take)
      .function("pattern", &SolverHandle::pattern)
      .function("result", &SolverHandle::result)
      .function("prove", &SolverHandle::prove)
      .function("proven", &SolverHandle::proven);
  emscripten::class_<DetectionHandle>("Detection")
      .constructor<const std::string&, const std::string&>()
      .function("advance", &DetectionHandle::advance)
      .function("result", &DetectionHandle::result);
  emscripten::class_<ShareHandle>("Share")
      .constructor<const val&>()
      .function("failure", &ShareHandle::failure)
      .function("advance", &ShareHandle::advance)
      .function("answers", &ShareHandle::answers);
  emscripten::function("measureSymmetries", &measuredSymmetries);
  emscripten::function("garmentFailure", &garmentFailure);
  emscripten::constant("maxFileBytes", static_cast<double>(kMaxFileBytes));
  emscripten::constant("maxValues", static_cast<double>(kMaxValues));
  emscripten::function("heapBytes", &heapBytes);
  emscripten::function("liveBytes", &liveBytes);
}

}  // namespace
}  // namespace seamwise
