#pragma once
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

namespace seamwise {

/// A value of a JSON document, as its file states it: plain data. Numbers keep the digits they were
/// written with, so that a document can be written again as it was read.
struct JsonValue {
  enum class Type : std::uint8_t { kNull, kBoolean, kNumber, kText, kArray, kObject };

  Type type = Type::kNull;
  std::string name;              ///< of a member of an object
  std::string text;              ///< of a text; of a number, boolean or null as it is written
  std::vector<JsonValue> items;  ///< of an array or object, in the order of the file

  bool isNull() const { return type == Type::kNull; }
  bool isBoolean() const { return type == Type::kBoolean; }
  bool isNumber() const { return type == Type::kNumber; }
  bool isText() const { return type == Type::kText; }
  bool isArray() const { return type == Type::kArray; }
  bool isObject() const { return type == Type::kObject; }

  /// Of a boolean.
  bool isTrue() const { return text == "true"; }
  /// Of a number; finite in a document that was read.
  double toNumber() const { return std::strtod(text.c_str(), nullptr); }

  std::size_t size() const { return items.size(); }
  const JsonValue& operator[](std::size_t k) const { return items[k]; }
  auto begin() const { return items.begin(); }
  auto end() const { return items.end(); }
};

}  // namespace seamwise
