#pragma once
#include <string>
#include <string_view>

#include "io/json_value.h"

namespace seamwise {

/// How documents come in and go out, which differs from program to program, so that each links an
/// end of its own. Native programs read and write JSON text (`json_text.cpp`). The WebAssembly
/// module leaves that to JavaScript, which has JSON built in, and hands documents over as they lie
/// in memory (`bindings/json_bytes.cpp`): "text" is then what JavaScript has made of one.

inline constexpr std::size_t kMaxFileBytes = 20'000'000;
inline constexpr std::size_t kMaxValues = 3'000'000;  ///< 20 MB of "[]" would need gigabytes

/// The document, as far as it goes: nesting and names are not checked yet, and it may end after the
/// first `kMaxValues`. Its defect says what ended it too early.
JsonDocument documentOf(std::string_view text);

/// The document as it leaves the program. Numbers are as short as reading them back exactly allows.
std::string textOf(const JsonDocument& document);

}  // namespace seamwise
