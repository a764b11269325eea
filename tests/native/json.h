#pragma once
#include <nlohmann/json.hpp>

namespace seamwise {

/// Of a library, so that what the core reads and writes is not judged by its own code.
using Json = nlohmann::ordered_json;

}  // namespace seamwise
