#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace seamwise {

enum class JsonKind : std::uint32_t { kNull, kFalse, kTrue, kNumber, kText, kList, kObject };

/// Of a list or an object that the text does not end.
inline constexpr std::uint32_t kOpen = 0xFFFFFFFF;

/// Where a text stands among those of its document. [bytes]
struct JsonText {
  std::uint32_t start, length;
};

/// One value of a document, or the name of a member. JavaScript reads and writes them, too, so
/// their layout is part of the boundary to it.
struct JsonNode {
  JsonKind kind = JsonKind::kNull;
  std::uint32_t after = 0;  ///< the node after this one and everything in it; kOpen
  union {
    double number;  ///< of a number
    JsonText text;
    std::uint32_t size;  ///< of a list or an object: its values
  };
  JsonNode() : number(0) {}
};
static_assert(sizeof(JsonNode) == 16);

/// Why there is no document, or only the beginning of one.
enum class JsonDefect : std::uint32_t {
  kNone,
  kTooLarge,
  kEmpty,
  kZeroByte,
  kUnexpected,
  kNoNumber,   ///< NaN or Infinity
  kOverflow,   ///< a number beyond all numbers
  kIncomplete  ///< the text ends too early
};

/// A JSON document: its values in the order of the text, the first of them the whole; in an object,
/// every value follows the text that names it. So a document takes 16 bytes a value and its texts.
struct JsonDocument {
  std::vector<JsonNode> nodes;
  std::string texts;
  JsonDefect defect = JsonDefect::kNone;  ///< what ends `nodes` too early
  std::uint32_t line = 0, column = 0;     ///< where, counted from 1, columns in bytes

  std::string_view text(const JsonNode& node) const {
    return std::string_view(texts).substr(node.text.start, node.text.length);
  }

  /// Appends a value that is no list, object or text.
  JsonNode& add(JsonKind kind);
  /// Appends a text, or the name of the value that follows.
  void addText(std::string_view text);
  /// Appends a list or an object, in which everything goes until that node is closed.
  std::size_t open(JsonKind kind);
  void close(std::size_t at);
};

struct JsonMember;

/// A value of a document, which must outlive it; or none, which is false. Of another kind than is
/// asked for, it is 0, or empty, or none.
class JsonValue {
 public:
  JsonValue() = default;
  explicit JsonValue(const JsonDocument& document, std::size_t at = 0)
      : document_(&document), at_(at) {}

  explicit operator bool() const { return document_; }
  JsonKind kind() const { return document_ ? node().kind : JsonKind::kNull; }
  bool isNull() const { return kind() == JsonKind::kNull; }
  bool isBoolean() const { return kind() == JsonKind::kFalse || kind() == JsonKind::kTrue; }
  bool isNumber() const { return kind() == JsonKind::kNumber; }
  bool isText() const { return kind() == JsonKind::kText; }
  bool isList() const { return kind() == JsonKind::kList; }
  bool isObject() const { return kind() == JsonKind::kObject; }

  bool isTrue() const { return kind() == JsonKind::kTrue; }
  double number() const { return isNumber() ? node().number : 0; }
  std::string text() const { return isText() ? std::string(document_->text(node())) : ""; }

  /// How many values a list or an object has.
  std::size_t size() const { return isList() || isObject() ? node().size : 0; }
  /// Of a list.
  std::vector<JsonValue> items() const;
  /// Of a list, none beyond its end; takes as long as it is far.
  JsonValue operator[](std::size_t index) const;
  /// Of an object, in the order of the text.
  std::vector<JsonMember> members() const;
  /// The member of an object; none when it is missing or null, or this is no object.
  JsonValue find(std::string_view name) const;

 private:
  const JsonNode& node() const { return document_->nodes[at_]; }

  const JsonDocument* document_ = nullptr;
  std::size_t at_ = 0;
};

struct JsonMember {
  std::string name;
  JsonValue value;
};

}  // namespace seamwise
