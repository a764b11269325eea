#include "base/decimal.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/product.h"

namespace seamwise {
namespace {

constexpr int kExact = 22;  // the greatest power of ten that a double holds exactly

double powerOfTen(int exponent) {
  double power = 1;
  for (int k = 0; k < exponent; ++k) power *= 10;
  return power;
}

/// Rounds value * 10^shift to a whole number, ties to even; exact if one power of ten is enough.
/// @param value   not negative; the product is below 1e15
std::uint64_t whole(double value, int shift) {
  for (; shift > kExact; shift -= kExact) value *= 1e22;
  for (; shift < -kExact; shift += kExact) value /= 1e22;
  const double power = powerOfTen(std::abs(shift));
  const double scaled = shift < 0 ? value / power : value * power;
  const double below = std::floor(scaled), rest = scaled - below;
  auto number = static_cast<std::uint64_t>(below);
  // The rounding error of a product decides between two numbers that seem equally near. The
  // remainder of a quotient is a double and needs no rounding.
  const double back = scaled * power;
  const double lost =
      shift < 0 ? (value - back) - lostOf(scaled, power, back) : lostOf(value, power, scaled);
  const bool is_tie = rest == 0.5;
  if (rest > 0.5 || (is_tie && (lost > 0 || (lost == 0 && number % 2 == 1)))) ++number;
  return number;
}

std::string signOf(double value) { return std::signbit(value) ? "-" : ""; }

/// `number` / 10^decimals.
std::string pointed(std::uint64_t number, int decimals) {
  std::string digits;  // digits in reverse order
  for (int count = 0; count <= decimals || number > 0; ++count, number /= 10) {
    if (count == decimals && count > 0) digits.push_back('.');
    digits.push_back(static_cast<char>('0' + number % 10));
  }
  std::reverse(digits.begin(), digits.end());
  return digits;
}

std::string withoutEndingZeros(std::string digits) {
  if (digits.find('.') == digits.npos) return digits;
  while (digits.back() == '0') digits.pop_back();
  if (digits.back() == '.') digits.pop_back();
  return digits;
}

/// The power of ten of the first digit of a positive number.
int exponentOf(double value) {
  int exponent = 0;
  for (; value >= 1e10; value /= 1e10) exponent += 10;
  for (; value < 1e-10; value *= 1e10) exponent -= 10;
  for (; value >= 10; value /= 10) ++exponent;
  for (; value < 1; value *= 10) --exponent;
  return exponent;
}

}  // namespace

std::string decimal(std::int64_t number) {
  const auto bits = static_cast<std::uint64_t>(number);
  const std::string digits = pointed(number < 0 ? 0 - bits : bits, 0);
  return number < 0 ? "-" + digits : digits;
}

std::string fixed(double value, int decimals) {
  const double size = std::abs(value);
  if (!(size * powerOfTen(decimals) < 1e15)) return significant(value, 15);
  return signOf(value) + pointed(whole(size, decimals), decimals);
}

std::string significant(double value, int digits) {
  if (std::isnan(value)) return "nan";
  const std::string sign = signOf(value);
  const double size = std::abs(value);
  if (std::isinf(size)) return sign + "inf";
  if (size == 0) return sign + "0";
  int exponent = exponentOf(size);
  std::uint64_t number = whole(size, digits - 1 - exponent);
  const auto end = static_cast<std::uint64_t>(powerOfTen(digits));
  // Rounding, or the division in exponentOf, may cross a power of ten.
  if (number >= end) number = whole(size, digits - 1 - ++exponent);
  if (exponent >= -4 && exponent < digits)
    return sign + withoutEndingZeros(pointed(number, digits - 1 - exponent));
  const std::string power = decimal(std::abs(exponent));
  return sign + withoutEndingZeros(pointed(number, digits - 1)) + (exponent < 0 ? "e-" : "e+") +
         (power.size() < 2 ? "0" : "") + power;
}

}  // namespace seamwise
