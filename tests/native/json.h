#pragma once
#include <nlohmann/json.hpp>

namespace seamwise {

/// What tests make texts from and read texts with.
using Json = nlohmann::ordered_json;

}  // namespace seamwise
