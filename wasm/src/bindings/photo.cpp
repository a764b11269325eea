// The face to JavaScript of the module that reads prints off pictures;
// web/src/solver/module/photo.d.mts describes it. Nothing but plain values crosses.
#include <emscripten/bind.h>

#include "bindings/module_ends.h"
#include "bindings/photo_handle.h"
#include "bindings/small_angles.h"

namespace seamwise {
namespace {

EMSCRIPTEN_BINDINGS(photo) {
  endWhenMemoryRunsOut();
  emscripten::class_<PhotoHandle>("Photo")
      .constructor<const val&>()
      .function("failure", &PhotoHandle::failure)
      .function("advance", &PhotoHandle::advance)
      .function("stage", &PhotoHandle::stage)
      .function("fraction", &PhotoHandle::fraction)
      .function("report", &PhotoHandle::report);
  emscripten::class_<PhotoTileHandle>("PhotoTile")
      .constructor<const val&>()
      .function("failure", &PhotoTileHandle::failure)
      .function("advance", &PhotoTileHandle::advance)
      .function("fraction", &PhotoTileHandle::fraction)
      .function("tile", &PhotoTileHandle::tile);
  emscripten::function("knownObject", &knownObjectIn);
}

}  // namespace
}  // namespace seamwise
