// The JavaScript interface of the marker module; web/src/solver/module/marker.d.mts describes it.
// Only plain values cross it.
#include <emscripten/bind.h>

#include "bindings/marker_handle.h"
#include "bindings/module_ends.h"
#include "bindings/small_angles.h"

namespace seamwise {
namespace {

EMSCRIPTEN_BINDINGS(marker) {
  endWhenMemoryRunsOut();
  emscripten::class_<MarkerHandle>("Marker")
      .constructor<const val&>()
      .function("failure", &MarkerHandle::failure)
      .function("advance", &MarkerHandle::advance)
      .function("stage", &MarkerHandle::stage)
      .function("fraction", &MarkerHandle::fraction)
      .function("count", &MarkerHandle::count)
      .function("layout", &MarkerHandle::layout)
      .function("report", &MarkerHandle::report);
}

}  // namespace
}  // namespace seamwise
