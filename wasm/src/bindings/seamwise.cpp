// The WebAssembly module's face to JavaScript; web/src/solver/module/seamwise.d.mts describes it.
// Nothing but plain values crosses, JSON documents among them as bytes (json_bytes.cpp), and no
// exception does: what goes wrong is kept as a failure that JavaScript asks for.
#include <emscripten/bind.h>
#include <emscripten/heap.h>
#include <malloc.h>

#include <optional>
#include <string>
#include <utility>

#include "bindings/share_handle.h"
#include "bindings/solver_handle.h"
#include "bindings/values.h"
#include "io/garment_json.h"
#include "io/json_ends.h"
#include "io/symmetry_json.h"

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
