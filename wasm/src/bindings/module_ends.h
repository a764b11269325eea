#pragma once
// Common definitions of all modules, included once in each of them.
#include <emscripten/em_js.h>
#include <emscripten/em_macros.h>

#include <new>

/// Replaces the C library's function, which takes 3 kB. Embind uses it to name types unknown to
/// JavaScript, and no module has any.
extern "C" int siprintf(char* text, const char* /*format*/, ...) {
  *text = 0;
  return 0;
}

/// Replaces the C library's function, which takes 2 kB. Sines use it for angles beyond a million,
/// which no file may contain (kMaxAngle).
extern "C" int __rem_pio2_large(double*, double* rest, int, int, int) {
  rest[0] = rest[1] = 0;
  return 0;
}

/// Leaves an instance that must not be used any more; web/src/solver/answers/failures.ts recognises
/// the message.
EM_JS(void, throwOutOfMemory, (), { throw new WebAssembly.RuntimeError('out of memory'); });

namespace seamwise {

inline void endWhenMemoryRunsOut() { std::set_new_handler(throwOutOfMemory); }

}  // namespace seamwise
