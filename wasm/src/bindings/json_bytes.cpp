// JSON documents at the boundary to JavaScript; web/src/solver/json has the other side. A head, the
// nodes and the texts follow each other, in the byte order of WebAssembly and all its hosts.
#include <cstring>

#include "io/json_ends.h"

namespace seamwise {
namespace {

struct Head {
  std::uint32_t nodes, defect, line, column;
};
static_assert(sizeof(Head) == sizeof(JsonNode));

}  // namespace

JsonDocument documentOf(std::string_view text) {
  JsonDocument document;
  Head head{};
  // A plain text instead of a document is not one of the known names, and counts as empty.
  if (text.size() < sizeof head) return document.defect = JsonDefect::kEmpty, document;
  std::memcpy(&head, text.data(), sizeof head);
  document.defect = static_cast<JsonDefect>(head.defect);
  document.line = head.line;
  document.column = head.column;
  const std::size_t bytes = head.nodes * sizeof(JsonNode);
  if ((text.size() - sizeof head) / sizeof(JsonNode) < head.nodes)
    return document.defect = JsonDefect::kEmpty, document;
  document.nodes.resize(head.nodes);
  std::memcpy(document.nodes.data(), text.data() + sizeof head, bytes);
  document.texts = text.substr(sizeof head + bytes);
  return document;
}

std::string textOf(const JsonDocument& document) {
  const Head head{static_cast<std::uint32_t>(document.nodes.size()), 0, 0, 0};
  const std::size_t bytes = document.nodes.size() * sizeof(JsonNode);
  std::string text;
  text.reserve(sizeof head + bytes + document.texts.size());
  text.append(reinterpret_cast<const char*>(&head), sizeof head);
  text.append(reinterpret_cast<const char*>(document.nodes.data()), bytes);
  return text += document.texts;
}

}  // namespace seamwise
