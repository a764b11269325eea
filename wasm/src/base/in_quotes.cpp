#include "base/in_quotes.h"

namespace seamwise {
namespace {

constexpr std::size_t kLongest = 60;  ///< bytes

struct Control {
  int code = -1;           ///< code point, -1 for a printable character
  std::size_t length = 1;  ///< bytes
};

/// The line end or terminal control character at a position, if any: U+0000 to U+001F, U+007F to
/// U+009F, U+2028 and U+2029.
Control controlAt(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t k) {
    return at + k < text.size() ? static_cast<unsigned char>(text[at + k]) : 0;
  };
  if (byte(0) < 0x20 || byte(0) == 0x7F) return {byte(0), 1};
  if (byte(0) == 0xC2 && byte(1) >= 0x80 && byte(1) < 0xA0) return {byte(1), 2};
  if (byte(0) == 0xE2 && byte(1) == 0x80 && (byte(2) == 0xA8 || byte(2) == 0xA9))
    return {0x2000 + byte(2) - 0x80, 3};
  return {};
}

}  // namespace

std::string onOneLine(const std::string& text) {
  std::string line;
  for (std::size_t k = 0; k < text.size();) {
    const Control control = controlAt(text, k);
    if (control.code < 0) {
      line += text[k];
    } else if (control.code == '\n') {
      line += "\\n";
    } else {
      line += "\\u";
      for (int shift = 12; shift >= 0; shift -= 4)
        line += "0123456789abcdef"[control.code >> shift & 15];
    }
    k += control.length;
  }
  return line;
}

std::string inQuotes(const std::string& name) {
  if (name.size() <= kLongest) return "'" + onOneLine(name) + "'";
  std::size_t cut = kLongest;
  while (cut > 0 && (static_cast<unsigned char>(name[cut]) & 0xC0) == 0x80) --cut;  // whole UTF-8
  return "'" + onOneLine(name.substr(0, cut)) + "...'";
}

}  // namespace seamwise
