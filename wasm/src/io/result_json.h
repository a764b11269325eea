#pragma once
#include <string>

#include "solve/result.h"

namespace seamwise {

/// Writes a result as a `seamwise-result/1` file. Milliseconds are 0: the core has no clock, the
/// caller fills them in.
std::string writeResult(const Result& result);

/// Writes a garment that is meshed but not solved yet, with the panel's edge of every outline edge.
std::string writePattern(const PrintedPattern& pattern);

}  // namespace seamwise
