#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "alignment/model/alignment.h"
#include "geometry/rigid_motion.h"
#include "io/json_value.h"

namespace seamwise {

/// Writes a JSON document value by value. Infinity and NaN become null.
class JsonWriter {
 public:
  /// Returns the document; the writer is empty afterwards.
  JsonDocument take() { return std::move(document_); }

  void openList() { open_.push_back(document_.open(JsonKind::kList)); }
  void openObject() { open_.push_back(document_.open(JsonKind::kObject)); }
  void close();
  /// Writes the name of the next value.
  void key(std::string_view name) { document_.addText(name); }

  void put(double value);
  void put(int value) { put(static_cast<double>(value)); }
  void put(std::uint32_t value) { put(static_cast<double>(value)); }
  void put(bool value) { document_.add(value ? JsonKind::kTrue : JsonKind::kFalse); }
  void put(std::string_view value) { document_.addText(value); }
  void put(const std::string& value) { put(std::string_view(value)); }
  void put(const char* value) { put(std::string_view(value)); }
  void put(const Vec2& point);
  void put(const Vec3& point);
  void put(const Alignment& alignment) { putPose(alignment.angle, alignment.translation); }
  /// Writes {angle, translation}, the form of an alignment. It omits `mirrored`, which readers of
  /// the document know.
  void put(const RigidMotion& motion) { putPose(motion.angle, motion.shift); }
  /// Copies a value of another document.
  void put(const JsonValue& value);
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

  /// Writes a list by calling `write` for every item.
  template <class List, class Write>
  void list(std::string_view name, const List& items, Write write) {
    key(name);
    openList();
    for (const auto& item : items) write(item);
    close();
  }

 private:
  void putPose(double angle, const Vec2& translation);
  template <class List>
  void putAll(const List& list) {
    openList();
    for (const auto& item : list) put(item);
    close();
  }

  JsonDocument document_;
  std::vector<std::size_t> open_;
};

}  // namespace seamwise
