#pragma once
// What every module begins with, once in each of them.
#include <emscripten/em_js.h>
#include <emscripten/em_macros.h>

#include <new>

/// Instead of the C library's, 3 kB: Embind would name types by it that JavaScript does not know,
/// of which no module has any.
extern "C" int siprintf(char* text, const char* /*format*/, ...) {
  *text = 0;
  return 0;
}

/// Instead of the C library's, 2 kB: what sines make of angles beyond a million, which no file may
/// have (kMaxAngle).
extern "C" int __rem_pio2_large(double*, double* rest, int, int, int) {
  rest[0] = rest[1] = 0;
  return 0;
}

/// Leaves an instance that nothing else must be asked of; web/src/solver/answers/broken.ts knows
/// the words.
EM_JS(void, throwOutOfMemory, (), { throw new WebAssembly.RuntimeError('out of memory'); });

namespace seamwise {

inline void endWhenMemoryRunsOut() { std::set_new_handler(throwOutOfMemory); }

}  // namespace seamwise
