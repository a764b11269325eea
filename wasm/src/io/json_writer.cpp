#include "io/json_writer.h"

#include <cmath>

#include "io/json.h"

namespace seamwise {

/// Whatever follows a value is parted from it.
void JsonWriter::separate() {
  if (text_.empty()) return;
  const char last = text_.back();
  if (last != '[' && last != '{' && last != ':') text_ += ',';
}

void JsonWriter::open(char bracket) {
  separate();
  text_ += bracket;
}

void JsonWriter::key(std::string_view name) {
  put(name);
  text_ += ':';
}

void JsonWriter::put(double value) {
  separate();
  if (!std::isfinite(value)) {
    text_ += "null";
    return;
  }
  char digits[64];
  text_.append(digits, nlohmann::detail::to_chars(digits, digits + sizeof digits, value));
}

void JsonWriter::put(int value) {
  separate();
  text_ += std::to_string(value);
}

void JsonWriter::put(std::uint32_t value) {
  separate();
  text_ += std::to_string(value);
}

void JsonWriter::put(bool value) {
  separate();
  text_ += value ? "true" : "false";
}

void JsonWriter::put(std::string_view value) {
  separate();
  text_ += '"';
  for (const char c : value) {
    constexpr char kHex[] = "0123456789abcdef";
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      text_ += '\\';
      text_ += c;
    } else if (code < 0x20) {
      text_ += "\\u00";
      text_ += kHex[code >> 4];
      text_ += kHex[code & 15];
    } else {
      text_ += c;
    }
  }
  text_ += '"';
}

void JsonWriter::put(const Vec2& point) {
  open('[');
  put(point.x());
  put(point.y());
  close(']');
}

void JsonWriter::put(const Alignment& alignment) {
  open('{');
  field("angle", alignment.angle);
  field("translation", alignment.translation);
  close('}');
}

}  // namespace seamwise
