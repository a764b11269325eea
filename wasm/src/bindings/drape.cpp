// The JavaScript interface of the drape module; web/src/solver/module/drape.d.mts describes it.
// Only plain values cross it; JSON documents cross as bytes (json_bytes.cpp).
#include <emscripten/bind.h>

#include "bindings/drape_handle.h"
#include "bindings/module_ends.h"
#include "io/json_ends.h"

namespace seamwise {
namespace {

EMSCRIPTEN_BINDINGS(drape) {
  endWhenMemoryRunsOut();
  emscripten::class_<DrapeHandle>("Drape")
      .constructor<const val&>()
      .function("failure", &DrapeHandle::failure)
      .function("advance", &DrapeHandle::advance)
      .function("stage", &DrapeHandle::stage)
      .function("fraction", &DrapeHandle::fraction)
      .function("form", &DrapeHandle::form)
      .function("mesh", &DrapeHandle::mesh)
      .function("shown", &DrapeHandle::shown)
      .function("positions", &DrapeHandle::positions)
      .function("report", &DrapeHandle::report);
  emscripten::constant("maxFileBytes", static_cast<double>(kMaxFileBytes));
  emscripten::constant("maxValues", static_cast<double>(kMaxValues));
}

}  // namespace
}  // namespace seamwise
