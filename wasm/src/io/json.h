#pragma once

namespace seamwise {

/// Throws what is caught as a fault of this program.
[[noreturn]] void jsonMisused();

}  // namespace seamwise

/// The JSON library's own exceptions would mean that a reader did not look before it took something
/// out of a document. So they need no messages of their own, which are a good part of its code.
#define JSON_THROW_USER(exception) ::seamwise::jsonMisused()
#include <nlohmann/json.hpp>
