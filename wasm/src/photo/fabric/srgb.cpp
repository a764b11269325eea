#include "photo/fabric/srgb.h"

#include <cmath>

namespace seamwise {

namespace {
constexpr int kLinearSteps = 1024, kCodeSteps = 8192;

/// Power for x > 0. The library's own adds 5 kB to a module.
float powerOf(float x, float exponent) { return std::exp(exponent * std::log(x)); }

float linearOfCode(float code) {
  return code <= 0.04045f ? code / 12.92f : powerOf((code + 0.055f) / 1.055f, 2.4f);
}
float codeOfLinear(float linear) {
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * powerOf(linear, 1 / 2.4f) - 0.055f;
}
}  // namespace

SrgbCurve::SrgbCurve() : linear_(kLinearSteps + 2), code_(kCodeSteps + 2) {
  for (int i = 0; i <= kLinearSteps; ++i)
    linear_[i] = linearOfCode(static_cast<float>(i) / kLinearSteps);
  for (int i = 0; i <= kCodeSteps; ++i) code_[i] = codeOfLinear(static_cast<float>(i) / kCodeSteps);
  linear_.back() = code_.back() = 1;
}

}  // namespace seamwise
