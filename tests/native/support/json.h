#pragma once
#include <nlohmann/json.hpp>

namespace seamwise {

/// JSON type with which tests write and read texts.
using Json = nlohmann::ordered_json;

}  // namespace seamwise
