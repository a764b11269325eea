#include "io/garment_json.h"
#include "io/json_writer.h"

namespace seamwise {
namespace {

using Type = JsonValue::Type;

/// The member of that name, which is made when it is missing.
JsonValue& member(JsonValue* object, const char* name) {
  for (JsonValue& item : object->items)
    if (item.name == name) return item;
  JsonValue& added = object->items.emplace_back();
  added.name = name;
  return added;
}

void state(JsonValue* properties, const char* name, Type type, const char* assumed) {
  JsonValue& property = member(properties, name);
  if (!property.isNull()) return;
  property.type = type;
  property.text = assumed;
}

/// One line for every value, indented by its depth.
void append(const JsonValue& value, std::size_t depth, std::string* out) {
  if (value.isText()) return appendQuoted(value.text, out);
  if (!value.isArray() && !value.isObject()) {
    *out += value.text;
    return;
  }
  *out += value.isObject() ? '{' : '[';
  for (const JsonValue& item : value) {
    *out += &item == &value.items.front() ? "\n" : ",\n";
    out->append(depth + 1, ' ');
    if (value.isObject()) {
      appendQuoted(item.name, out);
      *out += ": ";
    }
    append(item, depth + 1, out);
  }
  if (value.size() > 0) {
    *out += '\n';
    out->append(depth, ' ');
  }
  *out += value.isObject() ? '}' : ']';
}

}  // namespace

std::string writeGarment(const GarmentFile& file) {
  JsonValue document;
  document.type = Type::kObject;
  state(&document, "format", Type::kText, "seamwise-garment/1");
  for (const JsonValue& item : file.document)
    if (item.name != "format") document.items.push_back(item);
  JsonValue& properties = member(&document, "properties");
  if (properties.isNull()) properties.type = Type::kObject;
  state(&properties, "units_in_meter", Type::kNumber, "100");
  state(&properties, "curvature_coords", Type::kText, "relative");
  std::string text;
  append(document, 0, &text);
  return text + "\n";
}

}  // namespace seamwise
