#pragma once
#include <string>
#include <string_view>

#include "io/json_value.h"

namespace seamwise {

/// Input and output of documents. Each program links one implementation. Native programs read and
/// write JSON text (`json_text.cpp`). The WebAssembly module leaves JSON to JavaScript, which has a
/// built-in parser, and exchanges documents in their memory layout (`bindings/json_bytes.cpp`): its
/// "text" contains the bytes that JavaScript has made from a document.

inline constexpr std::size_t kMaxFileBytes = 20'000'000;
inline constexpr std::size_t kMaxValues = 3'000'000;  ///< 20 MB of "[]" would need gigabytes

/// Parses a document without checking nesting depth and duplicate names. For an invalid text,
/// returns the valid prefix with its defect. The document may end after the first `kMaxValues`.
JsonDocument documentOf(std::string_view text);

/// Serializes a document. Numbers have the fewest digits that restore them exactly.
std::string textOf(const JsonDocument& document);

}  // namespace seamwise
