#include <algorithm>
#include <cmath>
#include <set>

#include "io/json_input.h"

namespace seamwise {
namespace {

constexpr std::size_t kMaxDepth = 100;  // real files nest 7 deep; recursion over the tree is safe
constexpr std::size_t kMaxValues = 3'000'000;  // 20 MB of "[]" would otherwise need gigabytes

std::string lineAndColumn(std::string_view text, std::size_t position) {
  const std::string_view before = text.substr(0, std::min(position, text.size()));
  const std::size_t line =
      1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
  const std::size_t newline = before.rfind('\n');
  const std::size_t column = newline == before.npos ? before.size() : before.size() - newline - 1;
  return "line " + std::to_string(line) + ", column " +
         std::to_string(std::max<std::size_t>(column, 1));
}

void appendUtf8(unsigned code, std::string* text) {
  const auto append = [&](unsigned byte) { *text += static_cast<char>(byte); };
  const auto follow = [&](int shift) { append(0x80 | (code >> shift & 0x3F)); };
  if (code < 0x80) return append(code);
  if (code < 0x800) {
    append(0xC0 | code >> 6);
  } else {
    if (code < 0x10000) {
      append(0xE0 | code >> 12);
    } else {
      append(0xF0 | code >> 18);
      follow(12);
    }
    follow(6);
  }
  follow(0);
}

/// Reads a text without zero bytes by recursive descent (RFC 8259). Beyond the grammar it checks
/// depth, size, names that occur twice and numbers that are not finite.
class Parser {
 public:
  Parser(std::string_view text, const Place& place) : text_(text), place_(place) {}

  JsonValue document() {
    JsonValue root;
    readValue(&root, 0);
    skipSpace();
    if (at_ < text_.size()) broken();
    return root;
  }

 private:
  using Type = JsonValue::Type;

  /// The byte `ahead` of what comes next, zero beyond the end.
  unsigned byte(std::size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? static_cast<unsigned char>(text_[at_ + ahead]) : 0;
  }

  bool take(char wanted) {
    const bool there = byte() == static_cast<unsigned char>(wanted);
    if (there) ++at_;
    return there;
  }

  void expect(char wanted) {
    if (!take(wanted)) broken();
  }

  void skipSpace() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }

  void readValue(JsonValue* value, std::size_t depth) {
    if (++values_ > kMaxValues)
      place_.fail(Failure::kTooLarge, "has more than 3 million values; split it");
    skipSpace();
    const unsigned first = byte();
    if (first == '{' || first == '[') {
      readItems(value, depth);
    } else if (first == '"') {
      value->type = Type::kText;
      value->text = quoted();
    } else if (first == '-' || (first >= '0' && first <= '9')) {
      readNumber(value);
    } else {
      readWord(value);
    }
  }

  void readItems(JsonValue* value, std::size_t depth) {
    if (depth >= kMaxDepth)
      place_.fail(Failure::kNotJson,
                  "nests more than 100 lists or objects; it is no file of this program");
    const bool named = byte() == '{';
    const char closing = named ? '}' : ']';
    ++at_;
    value->type = named ? Type::kObject : Type::kArray;
    skipSpace();
    if (take(closing)) return;
    do {
      JsonValue& item = value->items.emplace_back();
      if (named) {
        skipSpace();
        item.name = quoted();
        skipSpace();
        expect(':');
      }
      readValue(&item, depth + 1);
      skipSpace();
    } while (take(','));
    expect(closing);
    if (named) checkNames(*value);
  }

  void checkNames(const JsonValue& object) const {
    std::set<std::string_view> names;
    for (const JsonValue& member : object)
      if (!names.insert(member.name).second)
        place_.fail(place_.shape, "has two entries named " + inQuotes(member.name) +
                                      (object.name.empty() ? "" : " in " + inQuotes(object.name)) +
                                      "; rename or remove one of them");
  }

  void readNumber(JsonValue* value) {
    const std::size_t start = at_;
    take('-');
    if (!take('0')) skipDigits();
    if (take('.')) skipDigits();
    if (take('e') || take('E')) {
      if (!take('+')) take('-');
      skipDigits();
    }
    value->type = Type::kNumber;
    value->text = text_.substr(start, at_ - start);
    if (!std::isfinite(value->toNumber()))
      place_.fail(place_.number, "has a number that is too large to be finite at " +
                                     lineAndColumn(text_, at_) + "; correct it");
  }

  void skipDigits() {
    const std::size_t start = at_;
    while (byte() >= '0' && byte() <= '9') ++at_;
    if (at_ == start) broken();
  }

  void readWord(JsonValue* value) {
    for (const std::string_view word : {"null", "true", "false"}) {
      const std::string_view given = text_.substr(at_, word.size());
      if (given.empty() || word.substr(0, given.size()) != given) continue;
      at_ += given.size();
      if (given.size() < word.size()) broken();
      value->type = word == "null" ? Type::kNull : Type::kBoolean;
      value->text = word;
      return;
    }
    broken();
  }

  std::string quoted() {
    expect('"');
    std::string text;
    while (!take('"')) {
      if (take('\\'))
        readEscape(&text);
      else
        readCharacter(&text);
    }
    return text;
  }

  /// No control character, and well-formed UTF-8: the shortest form of a code point.
  void readCharacter(std::string* text) {
    const unsigned first = byte(), second = byte(1);
    if (first < 0x20 || (first >= 0x80 && first < 0xC2) || first > 0xF4) broken();
    const std::size_t length = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    for (std::size_t k = 1; k < length; ++k)
      if ((byte(k) & 0xC0) != 0x80) broken(k);
    if ((first == 0xE0 && second < 0xA0) || (first == 0xED && second >= 0xA0) ||
        (first == 0xF0 && second < 0x90) || (first == 0xF4 && second >= 0x90))
      broken();
    text->append(text_.substr(at_, length));
    at_ += length;
  }

  /// What follows a backslash.
  void readEscape(std::string* text) {
    constexpr std::string_view kLetters = "\"\\/bfnrt", kMeant = "\"\\/\b\f\n\r\t";
    const std::size_t letter = kLetters.find(static_cast<char>(byte()));
    if (letter != kLetters.npos) {
      ++at_;
      *text += kMeant[letter];
      return;
    }
    unsigned code = readUnit();
    if (code >= 0xDC00 && code < 0xE000) broken();
    if (code >= 0xD800 && code < 0xDC00) {
      expect('\\');
      const unsigned low = readUnit();
      if (low < 0xDC00 || low >= 0xE000) broken();
      code = 0x10000 + ((code & 0x3FF) << 10 | (low & 0x3FF));
    }
    appendUtf8(code, text);
  }

  /// "u" and four hexadecimal digits.
  unsigned readUnit() {
    expect('u');
    unsigned unit = 0;
    for (int k = 0; k < 4; ++k, ++at_) {
      const unsigned digit = byte(), letter = digit | 0x20;
      const bool decimal = digit >= '0' && digit <= '9';
      if (!decimal && (letter < 'a' || letter > 'f')) broken();
      unit = unit << 4 | (decimal ? digit - '0' : letter - 'a' + 10);
    }
    return unit;
  }

  /// For what stands `ahead` of the place that was reached.
  [[noreturn]] void broken(std::size_t ahead = 0) const {
    const std::size_t position = at_ + ahead;
    const std::string where = lineAndColumn(text_, position + 1);
    if (position >= text_.size())
      place_.fail(Failure::kNotJson,
                  "is not complete JSON: it ends at " + where + "; save it again");
    const std::string_view word = text_.substr(position, 3);
    if (word == "NaN" || word == "nan" || word == "Inf" || word == "inf")
      place_.fail(Failure::kNotJson, "is not JSON at " + where +
                                         ": NaN and Infinity are not numbers in JSON; "
                                         "write a finite number or remove the field");
    place_.fail(Failure::kNotJson,
                "is not JSON: unexpected characters at " + where + "; correct it there");
  }

  std::string_view text_;
  const Place& place_;
  std::size_t at_ = 0;
  std::size_t values_ = 0;
};

}  // namespace

JsonValue parseDocument(std::string_view text, const Place& place) {
  if (text.size() > kMaxFileBytes)
    place.fail(Failure::kTooLarge, "is larger than 20 MB; split it or remove what is not needed");
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  std::string_view content = text;
  if (content.substr(0, kMark.size()) == kMark) content.remove_prefix(kMark.size());
  if (content.find_first_not_of(" \t\r\n") == content.npos)
    place.fail(Failure::kNotJson, "is empty; choose another file");
  // a zero byte stands for the end
  if (const std::size_t end = content.find('\0'); end != content.npos)
    place.fail(Failure::kNotJson, "is not JSON: it holds a zero byte at " +
                                      lineAndColumn(content, end + 1) + "; save it again");
  return Parser(content, place).document();
}

}  // namespace seamwise
