#include "recognition/cloth/srgb.h"

#include <cmath>

namespace seamwise {

namespace {
constexpr int kLinearSteps = 1024, kCodeSteps = 8192;

double linearOfCode(double code) {
  return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}
double codeOfLinear(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}
}  // namespace

SrgbCurve::SrgbCurve() : linear_(kLinearSteps + 2), code_(kCodeSteps + 2) {
  for (int i = 0; i <= kLinearSteps; ++i)
    linear_[i] = static_cast<float>(linearOfCode(static_cast<double>(i) / kLinearSteps));
  for (int i = 0; i <= kCodeSteps; ++i)
    code_[i] = static_cast<float>(codeOfLinear(static_cast<double>(i) / kCodeSteps));
  linear_.back() = code_.back() = 1;
}

}  // namespace seamwise
