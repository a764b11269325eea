#pragma once
#include <string>

#include "solve/result.h"

namespace seamwise {

/// The result as a `seamwise-result/1` file. Milliseconds are 0: the core has no clock, the caller
/// fills them in.
std::string writeResult(const Result& result);

}  // namespace seamwise
