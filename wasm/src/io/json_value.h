#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace seamwise {

enum class JsonKind : std::uint32_t { kNull, kFalse, kTrue, kNumber, kText, kList, kObject };

/// JsonNode::after of a list or an object that the text does not close.
inline constexpr std::uint32_t kOpen = 0xFFFFFFFF;

/// Range of a text in JsonDocument::texts. [bytes]
struct JsonText {
  std::uint32_t start, length;
};

/// One value of a document, or the name of a member. JavaScript reads and writes nodes, too, so
/// their memory layout is part of the interface to it.
struct JsonNode {
  JsonKind kind = JsonKind::kNull;
  std::uint32_t after = 0;  ///< the node after this one and everything in it; kOpen
  union {
    double number;
    JsonText text;
    std::uint32_t size;  ///< number of values in a list or an object
  };
  JsonNode() : number(0) {}
};
static_assert(sizeof(JsonNode) == 16);

/// The reason why a document is missing or incomplete.
enum class JsonDefect : std::uint32_t {
  kNone,
  kTooLarge,
  kEmpty,
  kZeroByte,
  kUnexpected,
  kNoNumber,   ///< NaN or Infinity
  kOverflow,   ///< a number too large for a double
  kIncomplete  ///< the text ends too early
};

/// A JSON document: its values in the order of the text. The first value is the whole document. In
/// an object, the node of its name precedes every value. A document takes 16 bytes a node, plus its
/// texts.
struct JsonDocument {
  std::vector<JsonNode> nodes;
  std::string texts;
  JsonDefect defect = JsonDefect::kNone;  ///< the reason why `nodes` end too early
  std::uint32_t line = 0, column = 0;     ///< position of the defect, counted from 1, columns in
                                          ///< bytes

  std::string_view text(const JsonNode& node) const {
    return std::string_view(texts).substr(node.text.start, node.text.length);
  }

  /// Appends a value other than a list, an object or a text.
  JsonNode& add(JsonKind kind);
  /// Appends a text, or the name of the value that follows.
  void addText(std::string_view text);
  /// Appends a list or an object and returns its node, which contains all values up to its close().
  std::size_t open(JsonKind kind);
  void close(std::size_t at);
};

struct JsonMember;

/// A value of a document, which must outlive it, or no value, which converts to false. Accessors
/// for another kind than the value's return 0, an empty result or no value.
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

  /// Number of values in a list or an object.
  std::size_t size() const { return isList() || isObject() ? node().size : 0; }
  /// The values of a list.
  std::vector<JsonValue> items() const;
  /// A value of a list; no value beyond its end. Takes time proportional to `index`.
  JsonValue operator[](std::size_t index) const;
  /// The members of an object, in the order of the text.
  std::vector<JsonMember> members() const;
  /// A member of an object; no value if it is missing or null, or if this is no object.
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
