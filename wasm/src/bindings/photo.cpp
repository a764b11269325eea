// The JavaScript interface of the photo module; web/src/solver/module/photo.d.mts describes it.
// Only plain values cross it.
#include <emscripten/bind.h>

#include "bindings/module_ends.h"
#include "bindings/photo_handle.h"
#include "bindings/small_angles.h"

namespace seamwise {
namespace {

EMSCRIPTEN_BINDINGS(photo) {
  endWhenMemoryRunsOut();
  emscripten::class_<PictureWork>("PictureWork")
      .function("failure", &PictureWork::failure)
      .function("advance", &PictureWork::advance)
      .function("stage", &PictureWork::stage)
      .function("fraction", &PictureWork::fraction)
      .function("answer", &PictureWork::answer);
  emscripten::function("photo", &photoWork, emscripten::allow_raw_pointers());
  emscripten::function("photoTile", &photoTileWork, emscripten::allow_raw_pointers());
  emscripten::function("photoObject", &photoObjectWork, emscripten::allow_raw_pointers());
}

}  // namespace
}  // namespace seamwise
