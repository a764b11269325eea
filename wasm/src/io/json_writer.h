#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "alignment/alignment.h"
#include "geometry/vec2.h"

namespace seamwise {

/// Writes JSON as text, value by value, without a document in between. Numbers are as short as
/// reading them back exactly allows.
class JsonWriter {
 public:
  /// The text; the writer is empty afterwards.
  std::string take() { return std::move(text_); }

  void open(char bracket);
  void close(char bracket) { text_ += bracket; }
  /// The name of the value that comes next; a plain word.
  void key(std::string_view name);

  void put(double value);
  void put(int value);
  void put(std::uint32_t value);
  void put(bool value);
  void put(std::string_view value);
  void put(const std::string& value) { put(std::string_view(value)); }
  void put(const char* value) { put(std::string_view(value)); }
  void put(const Vec2& point);
  void put(const Alignment& alignment);
  template <std::size_t n>
  void put(const std::array<int, n>& list) {
    putAll(list);
  }
  template <class T>
  void put(const std::vector<T>& list) {
    putAll(list);
  }

  template <class T>
  void field(std::string_view name, const T& value) {
    key(name);
    put(value);
  }

  /// A list with what `write` writes for every item.
  template <class List, class Write>
  void list(std::string_view name, const List& items, Write write) {
    key(name);
    open('[');
    for (const auto& item : items) write(item);
    close(']');
  }

 private:
  void separate();
  template <class List>
  void putAll(const List& list) {
    open('[');
    for (const auto& item : list) put(item);
    close(']');
  }

  std::string text_;
};

}  // namespace seamwise
