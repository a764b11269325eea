#pragma once
#include <cstdint>
#include <string>

namespace seamwise {

/// Numbers as messages show them, the same on every machine. Written here because the C library's
/// own functions would be a good part of the WebAssembly module: they hold for numbers of any size
/// and any number of digits.

/// A whole number: "-12".
std::string decimal(std::int64_t number);

/// With that many digits after the point, as "%.*f" writes it: "12.50". Numbers of more than 15
/// digits as `significant` writes them.
/// @param decimals   at most 6
std::string fixed(double value, int decimals);

/// With at most that many significant digits, as "%.*g" writes it: "12.5", "1e+20". Of numbers
/// beyond all lengths, below 1e-7 or above 1e30, the last of 15 digits may be off by one.
/// @param digits   at most 15
std::string significant(double value, int digits);

}  // namespace seamwise
