#include "io/json_value.h"

namespace seamwise {

JsonNode& JsonDocument::add(JsonKind kind) {
  JsonNode& node = nodes.emplace_back();
  node.kind = kind;
  node.after = static_cast<std::uint32_t>(nodes.size());
  return node;
}

void JsonDocument::addText(std::string_view text) {
  add(JsonKind::kText).text = {static_cast<std::uint32_t>(texts.size()),
                               static_cast<std::uint32_t>(text.size())};
  texts += text;
}

std::size_t JsonDocument::open(JsonKind kind) {
  add(kind).after = kOpen;
  return nodes.size() - 1;
}

void JsonDocument::close(std::size_t at) {
  const std::size_t name = nodes[at].kind == JsonKind::kObject ? 1 : 0;
  nodes[at].after = static_cast<std::uint32_t>(nodes.size());
  nodes[at].size = 0;
  for (std::size_t k = at + 1; k < nodes.size(); k = nodes[k + name].after) ++nodes[at].size;
}

std::vector<JsonValue> JsonValue::items() const {
  std::vector<JsonValue> items;
  if (!isList()) return items;
  items.reserve(size());
  for (std::size_t k = at_ + 1; k < node().after; k = document_->nodes[k].after)
    items.emplace_back(*document_, k);
  return items;
}

JsonValue JsonValue::operator[](std::size_t index) const {
  if (index >= size()) return {};
  std::size_t k = at_ + 1;
  for (; index > 0; --index) k = document_->nodes[k].after;
  return JsonValue(*document_, k);
}

std::vector<JsonMember> JsonValue::members() const {
  std::vector<JsonMember> members;
  if (!isObject()) return members;
  members.reserve(size());
  for (std::size_t k = at_ + 1; k < node().after; k = document_->nodes[k + 1].after)
    members.push_back({JsonValue(*document_, k).text(), JsonValue(*document_, k + 1)});
  return members;
}

JsonValue JsonValue::find(std::string_view name) const {
  if (!isObject()) return {};
  for (std::size_t k = at_ + 1; k < node().after; k = document_->nodes[k + 1].after)
    if (document_->text(document_->nodes[k]) == name)
      return document_->nodes[k + 1].kind == JsonKind::kNull ? JsonValue()
                                                             : JsonValue(*document_, k + 1);
  return {};
}

}  // namespace seamwise
