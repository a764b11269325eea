// JSON text, for native programs.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/decimal.h"
#include "io/json_ends.h"

namespace seamwise {
namespace {

using Json = nlohmann::json;

/// Builds a document from the parser's events.
class Builder {
 public:
  using number_integer_t = Json::number_integer_t;
  using number_unsigned_t = Json::number_unsigned_t;
  using number_float_t = Json::number_float_t;
  using string_t = Json::string_t;
  using binary_t = Json::binary_t;

  explicit Builder(std::string_view text) : text_(text) {}

  // NOLINTBEGIN(readability-identifier-naming): names required by the parser
  bool null() { return add(JsonKind::kNull); }
  bool boolean(bool value) { return add(value ? JsonKind::kTrue : JsonKind::kFalse); }
  bool number_integer(number_integer_t value) { return number(static_cast<double>(value)); }
  bool number_unsigned(number_unsigned_t value) { return number(static_cast<double>(value)); }
  bool number_float(number_float_t value, const string_t&) { return number(value); }
  bool string(string_t& value) { return document_.addText(value), isOneMore(); }
  bool binary(binary_t&) { return false; }
  bool start_object(std::size_t) { return open(JsonKind::kObject); }
  bool key(string_t& name) { return document_.addText(name), true; }
  bool end_object() { return close(); }
  bool start_array(std::size_t) { return open(JsonKind::kList); }
  bool end_array() { return close(); }

  bool parse_error(std::size_t position, const std::string&, const Json::exception& error) {
    constexpr int kNumberOverflow = 406;
    // The token starts up to a letter or two before the position at which the parser failed.
    const std::string_view near = text_.substr(position > 9 ? position - 9 : 0, 18);
    const auto holds = [&](const char* word) { return near.find(word) != near.npos; };
    end(error.id == kNumberOverflow                                    ? JsonDefect::kOverflow
        : holds("NaN") || holds("nan") || holds("Inf") || holds("inf") ? JsonDefect::kNoNumber
        : position > text_.size()                                      ? JsonDefect::kIncomplete
                                                                       : JsonDefect::kUnexpected,
        position);
    return false;
  }
  // NOLINTEND(readability-identifier-naming)

  /// @param position   of the last byte that was read, counted from 1 [bytes]
  void end(JsonDefect defect, std::size_t position) {
    const std::string_view before = text_.substr(0, std::min(position, text_.size()));
    const std::size_t newline = before.rfind('\n');
    const std::size_t column = newline == before.npos ? before.size() : before.size() - newline - 1;
    document_.defect = defect;
    document_.line = static_cast<std::uint32_t>(1 + std::count(before.begin(), before.end(), '\n'));
    document_.column = static_cast<std::uint32_t>(std::max<std::size_t>(column, 1));
  }

  JsonDocument take() { return std::move(document_); }

 private:
  /// Counts a value. Returns false beyond kMaxValues, which ends parsing.
  bool isOneMore() { return ++values_ <= kMaxValues; }

  bool add(JsonKind kind) { return document_.add(kind), isOneMore(); }

  bool number(double value) {
    document_.add(JsonKind::kNumber).number = value;
    return isOneMore();
  }

  bool open(JsonKind kind) {
    open_.push_back(document_.open(kind));
    return isOneMore();
  }

  bool close() {
    document_.close(open_.back());
    open_.pop_back();
    return true;
  }

  std::string_view text_;
  JsonDocument document_;
  std::vector<std::size_t> open_;
  std::size_t values_ = 0;
};

void writeText(std::string_view text, std::string& out) {
  out += '"';
  for (const char c : text) {
    constexpr char kHex[] = "0123456789abcdef";
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (code < 0x20) {
      out += "\\u00";
      out += kHex[code >> 4];
      out += kHex[code & 15];
    } else {
      out += c;
    }
  }
  out += '"';
}

void writeNumber(double value, std::string& out) {
  constexpr double kWhole = 1e15;  // smaller whole numbers are written without a fraction
  if (value == std::floor(value) && std::abs(value) < kWhole) {
    out += decimal(static_cast<long long>(value));
    return;
  }
  char digits[64];
  out.append(digits, nlohmann::detail::to_chars(digits, digits + sizeof digits, value));
}

void write(const JsonDocument& document, std::size_t at, std::string& out) {
  const JsonNode& node = document.nodes[at];
  const bool named = node.kind == JsonKind::kObject;
  switch (node.kind) {
    case JsonKind::kNull:
      out += "null";
      return;
    case JsonKind::kFalse:
      out += "false";
      return;
    case JsonKind::kTrue:
      out += "true";
      return;
    case JsonKind::kNumber:
      writeNumber(node.number, out);
      return;
    case JsonKind::kText:
      writeText(document.text(node), out);
      return;
    case JsonKind::kList:
    case JsonKind::kObject:
      break;
  }
  out += named ? '{' : '[';
  for (std::size_t k = at + 1; k < node.after; k = document.nodes[k + named].after) {
    if (k > at + 1) out += ',';
    if (named) {
      writeText(document.text(document.nodes[k]), out);
      out += ':';
    }
    write(document, k + named, out);
  }
  out += named ? '}' : ']';
}

}  // namespace

JsonDocument documentOf(std::string_view text) {
  JsonDocument nothing;
  nothing.defect = JsonDefect::kTooLarge;
  if (text.size() > kMaxFileBytes) return nothing;
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  std::string_view content = text;
  if (content.substr(0, kMark.size()) == kMark) content.remove_prefix(kMark.size());
  nothing.defect = JsonDefect::kEmpty;
  if (content.find_first_not_of(" \t\r\n") == content.npos) return nothing;
  Builder builder(content);
  // The parser would treat a zero byte as the end of the text.
  if (const std::size_t zero = content.find('\0'); zero != content.npos)
    builder.end(JsonDefect::kZeroByte, zero + 1);
  else
    Json::sax_parse(content.begin(), content.end(), &builder);
  return builder.take();
}

std::string textOf(const JsonDocument& document) {
  std::string text;
  write(document, 0, text);
  return text;
}

}  // namespace seamwise
