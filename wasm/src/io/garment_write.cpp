#include "io/garment_json.h"

namespace seamwise {
namespace {

void state(Json* properties, const char* key, Json assumed) {
  Json& member = (*properties)[key];
  if (member.is_null()) member = std::move(assumed);
}

}  // namespace

std::string writeGarment(const GarmentFile& file) {
  Json document = Json::object();
  document["format"] = "seamwise-garment/1";
  auto& members = document.get_ref<Json::object_t&>();
  for (const auto& [key, value] : file.document.items())
    if (key != "format") members.emplace_back(key, value);  // names are known to differ
  Json& properties = document["properties"];
  if (properties.is_null()) properties = Json::object();
  state(&properties, "units_in_meter", 100);
  state(&properties, "curvature_coords", "relative");
  constexpr int kIndent = 1;
  return document.dump(kIndent) + "\n";
}

}  // namespace seamwise
