// The JavaScript interface of the WebAssembly module; web/src/solver/module/seamwise.d.mts
// describes it. Only plain values cross it; JSON documents cross as bytes (json_bytes.cpp). Errors
// are stored as failures for JavaScript to fetch, except for lack of memory (module_ends.h).
#include <emscripten/bind.h>
#include <emscripten/heap.h>
#include <malloc.h>

#include <optional>
#include <string>
#include <utility>

#include "bindings/module_ends.h"
#include "bindings/share_handle.h"
#include "bindings/solver_handle.h"
#include "bindings/values.h"
#include "io/garment_document.h"
#include "io/garment_json.h"
#include "io/json_ends.h"
#include "io/symmetry_json.h"

namespace seamwise {
namespace {

/// The document, or the reason for its absence.
val documentValue(const Outcome<std::string>& made) {
  val answer = val::object();
  answer.set("document", copied(made.ok() ? made.value() : std::string()));
  answer.set("failure", made.ok() ? val::null() : failureValue(made.error()));
  return answer;
}

/// The symmetries of a garment's own shape, detected in steps.
class DetectionHandle {
 public:
  DetectionHandle(const std::string& text, const std::string& name) {
    Outcome<GarmentFile> file = readGarment(text, name);
    if (file.ok()) {
      garment_ = std::move(file).value().garment;
      detection_.emplace(garment_);
    } else {
      error_ = file.error();
    }
  }

  bool advance(int steps) {
    bool more = detection_.has_value();
    for (; more && steps > 0; --steps) more = detection_->advance();
    return more;
  }

  /// Returns a document, once advance() has returned false.
  val result() const {
    if (error_) return documentValue(*error_);
    return documentValue(writeSymmetries(garment_, detection_->found()));
  }

 private:
  Garment garment_;
  std::optional<SymmetryDetection> detection_;
  std::optional<Error> error_;
};

val measuredSymmetries(const std::string& text, const std::string& name, const std::string& wanted,
                       const std::string& wanted_name) {
  const Outcome<GarmentFile> file = readGarment(text, name);
  if (!file.ok()) return documentValue(file.error());
  const auto requests = readSymmetries(wanted, wanted_name);
  if (!requests.ok()) return documentValue(requests.error());
  const Garment& garment = file.value().garment;
  const auto measured = measureSymmetries(garment, requests.value());
  if (!measured.ok()) return documentValue(inFile(measured.error(), wanted_name));
  return documentValue(writeMeasured(garment, measured.value()));
}

val garmentValue(const std::string& text, const std::string& name) {
  return documentValue(garmentDocument(text, name));
}

double liveBytes() { return static_cast<double>(static_cast<unsigned>(mallinfo().uordblks)); }
double heapBytes() { return static_cast<double>(emscripten_get_heap_size()); }

EMSCRIPTEN_BINDINGS(seamwise) {
  endWhenMemoryRunsOut();
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
  emscripten::function("garment", &garmentValue);
  emscripten::constant("maxFileBytes", static_cast<double>(kMaxFileBytes));
  emscripten::constant("maxValues", static_cast<double>(kMaxValues));
  emscripten::function("heapBytes", &heapBytes);
  emscripten::function("liveBytes", &liveBytes);
}

}  // namespace
}  // namespace seamwise
