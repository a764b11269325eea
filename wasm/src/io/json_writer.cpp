#include "io/json_writer.h"

#include <cmath>

namespace seamwise {

void JsonWriter::close() {
  document_.close(open_.back());
  open_.pop_back();
}

void JsonWriter::put(double value) {
  if (std::isfinite(value))
    document_.add(JsonKind::kNumber).number = value;
  else
    document_.add(JsonKind::kNull);
}

void JsonWriter::put(const Vec2& point) {
  openList();
  put(point.x());
  put(point.y());
  close();
}

void JsonWriter::put(const Vec3& point) {
  openList();
  for (int c = 0; c < 3; ++c) put(point[c]);
  close();
}

void JsonWriter::putPose(double angle, const Vec2& translation) {
  openObject();
  field("angle", angle);
  field("translation", translation);
  close();
}

void JsonWriter::put(const JsonValue& value) {
  if (value.isNumber()) return put(value.number());
  if (value.isText()) return put(value.text());
  if (value.isList()) return putAll(value.items());
  if (!value.isObject()) {
    document_.add(value.kind());
    return;
  }
  openObject();
  for (const auto& [name, member] : value.members()) field(name, member);
  close();
}

}  // namespace seamwise
