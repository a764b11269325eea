#pragma once
#include <vector>

namespace seamwise {

/// Converts between sRGB codes and linear light, both in [0, 1] (IEC 61966-2-1), by tables with
/// errors below 1e-4. Other values are clamped.
class SrgbCurve {
 public:
  SrgbCurve();
  float linear(float code) const { return read(linear_, code); }
  float code(float linear) const { return read(code_, linear); }

 private:
  static float read(const std::vector<float>& table, float x) {
    const float last = static_cast<float>(table.size() - 2);
    const float t = x > 0 ? (x < 1 ? x * last : last) : 0.0f;  // NaN counts as 0
    const int i = static_cast<int>(t);
    return table[i] + (t - static_cast<float>(i)) * (table[i + 1] - table[i]);
  }
  std::vector<float> linear_, code_;  ///< equally spaced, the last value twice
};

}  // namespace seamwise
