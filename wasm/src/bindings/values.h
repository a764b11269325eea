#pragma once
// Values at the boundary to JavaScript.
#include <emscripten/val.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/outcome.h"

namespace seamwise {

using emscripten::val;

inline val failureValue(const std::optional<Error>& error) {
  if (!error) return val::null();
  val failure = val::object();
  failure.set("code", static_cast<int>(error->code));
  failure.set("message", error->message);
  failure.set("piece", error->piece);
  failure.set("seam", error->seam);
  failure.set("reason", error->reason);
  return failure;
}

/// A copy for JavaScript: a view of the heap becomes invalid when memory grows.
template <class Value>
val copied(std::size_t size, const Value* values) {
  return val(emscripten::typed_memory_view(size, values)).template call<val>("slice");
}

inline val copied(const std::string& bytes) {
  return copied(bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
}

inline val copied(const std::vector<double>& numbers) {
  return copied(numbers.size(), numbers.data());
}

}  // namespace seamwise
