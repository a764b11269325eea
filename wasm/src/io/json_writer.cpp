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

void JsonWriter::putPose(double angle, const Vec2& translation) {
  openObject();
  field("angle", angle);
  field("translation", translation);
  close();
}

}  // namespace seamwise
