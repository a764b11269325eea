#pragma once
#include <cstdint>
#include <string>

namespace seamwise {

/// Number formatting for messages, the same on every machine. The C library's functions support
/// numbers of any size and any number of digits, and would be a large part of the WebAssembly
/// module.

/// A whole number: "-12".
std::string decimal(std::int64_t number);

/// Formats with that many digits after the point, like "%.*f": "12.50". Numbers of more than 15
/// digits are formatted like `significant`.
/// @param decimals   at most 6
std::string fixed(double value, int decimals);

/// Formats with at most that many significant digits, like "%.*g": "12.5", "1e+20". The last of 15
/// digits may be off by one below 1e-7 or above 1e30, beyond all lengths.
/// @param digits   at most 15
std::string significant(double value, int digits);

}  // namespace seamwise
