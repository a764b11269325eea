// The WebAssembly module's face to JavaScript; web/src/solver/module/seamwise.d.mts describes it.
// Nothing but plain values crosses, and no exception does: what goes wrong is kept as a failure
// that JavaScript asks for.
#include <emscripten/bind.h>
#include <emscripten/heap.h>
#include <emscripten/val.h>
#include <malloc.h>

#include <exception>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/garment_json.h"
#include "io/problem_json.h"
#include "io/result_json.h"
#include "io/share_numbers.h"
#include "io/symmetry_json.h"
#include "solve/solver.h"

namespace seamwise {
namespace {

using emscripten::val;

val failureValue(const std::optional<Error>& error) {
  if (!error) return val::null();
  val failure = val::object();
  failure.set("code", static_cast<int>(error->code));
  failure.set("message", error->message);
  failure.set("piece", error->piece);
  failure.set("seam", error->seam);
  failure.set("reason", error->reason);
  return failure;
}

/// Runs `work`; what it throws becomes the error it returns.
template <class Work>
std::optional<Error> caught(Work work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return Error{Failure::kInternal, "There is not enough memory for this problem."};
  } catch (const std::exception& broken) {
    return Error{Failure::kInternal, std::string("The solver broke: ") + broken.what() + "."};
  } catch (...) {
    return Error{Failure::kInternal, "The solver broke."};
  }
}

/// `make` gives an Outcome<std::string>; the text, or why there is none.
template <class Make>
val textValue(Make make) {
  val answer = val::object();
  std::string text;
  const std::optional<Error> error = caught([&]() -> std::optional<Error> {
    Outcome<std::string> made = make();
    if (!made.ok()) return made.error();
    text = std::move(made).value();
    return std::nullopt;
  });
  answer.set("text", text);
  answer.set("failure", failureValue(error));
  return answer;
}

/// A view of the heap dies when memory grows, so JavaScript gets a copy.
val copied(const std::vector<double>& numbers) {
  return val(emscripten::typed_memory_view(numbers.size(), numbers.data())).call<val>("slice");
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

/// A solve as JavaScript holds it. After a failure every call is harmless and does nothing.
class SolverHandle {
 public:
  explicit SolverHandle(const val& problem) {
    error_ = caught([&]() -> std::optional<Error> {
      Outcome<Problem> made = makeProblem(problemTexts(problem));
      if (!made.ok()) return made.error();
      Outcome<Solver> solver = Solver::make(std::move(made).value(), &memo);
      if (!solver.ok()) return solver.error();
      solver_.emplace(std::move(solver).value());
      return std::nullopt;
    });
    if (error_) solver_.reset();
  }

  val failure() const { return failureValue(error_); }

  bool advance(int steps) {
    bool more = false;
    guard([&]() -> std::optional<Error> {
      more = solver_->advance(steps);
      return std::nullopt;
    });
    return more;
  }

  std::string phase() const {
    const bool deforming = solver_ && solver_->phase() >= Phase::kDeformation;
    return deforming ? "deformation" : "alignment";
  }

  int attempt() const { return solver_ ? solver_->attempt() : 0; }

  double fraction() const { return solver_ ? solver_->fraction() : 0; }

  val partial() {
    std::vector<double> flat;
    guard([&]() -> std::optional<Error> {
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
      AlignmentSearch* const search = solver_->searching();
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

  /// The garment as it is meshed, not solved; meaningful at any time.
  std::string pattern() {
    std::string text;
    guard([&]() -> std::optional<Error> {
      text = writePattern(solver_->unsolved());
      return std::nullopt;
    });
    return text;
  }

  std::string result() {
    std::string text;
    guard([&]() -> std::optional<Error> {
      const Outcome<Result> finished = solver_->finish();
      if (!finished.ok()) return finished.error();
      text = writeResult(finished.value());
      return std::nullopt;
    });
    return text;
  }

 private:
  template <class Work>
  void guard(Work work) {
    if (solver_) error_ = caught(std::move(work));
    if (error_) solver_.reset();
  }

  struct Lent {
    std::weak_ptr<AlignmentSearch::Share> share;
    std::vector<Component> components;
  };
  std::optional<Solver> solver_;
  std::optional<Error> error_;
  std::vector<Lent> lent_;  ///< by number
};

/// A share of a search that runs on another thread, as JavaScript holds it.
class ShareHandle {
 public:
  explicit ShareHandle(const val& numbers) {
    error_ = caught([&]() -> std::optional<Error> {
      auto order = readShare(emscripten::convertJSArrayToNumberVector<double>(numbers));
      if (!order) return Error{Failure::kInternal, "A share of a search came damaged."};
      work_ = std::make_unique<Work>(*std::move(order));
      return std::nullopt;
    });
  }

  val failure() const { return failureValue(error_); }

  bool advance(int steps) {
    bool more = work_ != nullptr;
    error_ = caught([&]() -> std::optional<Error> {
      for (int k = 0; more && k < steps; ++k) more = work_->share.step();
      return std::nullopt;
    });
    return more && !error_;
  }

  /// Once nothing is left to do.
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

val detectedSymmetries(const std::string& text, const std::string& name) {
  return textValue([&]() -> Outcome<std::string> {
    const Outcome<GarmentFile> file = readGarment(text, name);
    if (!file.ok()) return file.error();
    const Garment& garment = file.value().garment;
    return writeSymmetries(garment, detectSymmetries(garment));
  });
}

val measuredSymmetries(const std::string& text, const std::string& name, const std::string& wanted,
                       const std::string& wanted_name) {
  return textValue([&]() -> Outcome<std::string> {
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

val convertedGarment(const std::string& text, const std::string& name) {
  return textValue([&]() -> Outcome<std::string> {
    const Outcome<GarmentFile> file = readGarment(text, name);
    if (!file.ok()) return file.error();
    return writeGarment(file.value());
  });
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
      .function("take", &SolverHandle::take)
      .function("pattern", &SolverHandle::pattern)
      .function("result", &SolverHandle::result);
  emscripten::class_<ShareHandle>("Share")
      .constructor<const val&>()
      .function("failure", &ShareHandle::failure)
      .function("advance", &ShareHandle::advance)
      .function("answers", &ShareHandle::answers);
  emscripten::function("detectSymmetries", &detectedSymmetries);
  emscripten::function("measureSymmetries", &measuredSymmetries);
  emscripten::function("convertGarment", &convertedGarment);
  emscripten::function("heapBytes", &heapBytes);
  emscripten::function("liveBytes", &liveBytes);
}

}  // namespace
}  // namespace seamwise
