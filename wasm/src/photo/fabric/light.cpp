#include "photo/fabric/light.h"

#include <algorithm>
#include <cmath>

namespace seamwise {

namespace {
constexpr int kLightRounds = 14;          // later ones change the field by less than 0.1 %
constexpr int kPlainLightRounds = 3;      // rounds before errors are weighted by their size
constexpr float kLightStiffness = 0.02f;  // share of a node's mean weight
constexpr float kNoisyLight = 0.02f;      // linear light at which noise equals the signal
constexpr float kGlareCode = 0.98f;       // the camera clips coded values above it
constexpr float kLightTail = 3;           // errors beyond this many mean errors count little
}  // namespace

LightFit::LightFit(LatticeCanvas canvas, const SrgbCurve& curve, int width, int height,
                   double cell_size, double nodes_across)
    : canvas_(std::move(canvas)) {
  const double longer = std::max(width, height);
  field_ =
      SmoothField(3, width, height,
                  std::clamp(cell_size / 2, longer / (2 * nodes_across), longer / nodes_across));
  for (int c = 0; c < 3; ++c) {
    std::vector<float>& plane = canvas_.planes[c];
    weights_[c].resize(plane.size());
    for (std::size_t k = 0; k < plane.size(); ++k) {
      const float code = plane[k], light = curve.linear(code);
      plane[k] = std::log(std::max(light, kNoisyLight / 16));
      const float trust = light * light / (light * light + kNoisyLight * kNoisyLight);
      weights_[c][k] = canvas_.seen[k] && code < kGlareCode ? trust : 0.0f;
    }
  }
}

bool LightFit::advance() {
  for (int c = 0; c < 3; ++c) fit(c);
  if (++round_ < kLightRounds) return true;
  center();
  return false;
}

void LightFit::fit(int channel) {
  const std::vector<float>& logs = canvas_.planes[channel];
  const std::vector<float>& weights = weights_[channel];
  const std::size_t places = static_cast<std::size_t>(canvas_.n) * canvas_.n;
  std::vector<float> rest(logs.size()), print(places), total(places);
  float values[3];
  for (int b = 0, k = 0; b < canvas_.rows(); ++b) {
    for (int a = 0; a < canvas_.columns(); ++a, ++k) {
      if (weights[k] == 0) continue;
      field_.at(canvas_.x[k], canvas_.y[k], values);
      rest[k] = logs[k] - values[channel];
      print[canvas_.place(a, b)] += weights[k] * rest[k];
      total[canvas_.place(a, b)] += weights[k];
    }
  }
  double errors = 0, trust = 1e-9;
  for (int b = 0, k = 0; b < canvas_.rows(); ++b) {
    for (int a = 0; a < canvas_.columns(); ++a, ++k) {
      if (weights[k] == 0) continue;
      const std::size_t place = canvas_.place(a, b);
      rest[k] -= print[place] / total[place];
      errors += weights[k] * std::abs(rest[k]);
      trust += weights[k];
    }
  }
  const float tail = kLightTail * static_cast<float>(errors / trust) + 1e-6f;
  FieldSums sums(field_);
  double weight = 0;
  for (std::size_t k = 0; k < rest.size(); ++k) {
    if (weights[k] == 0) continue;
    const float size = round_ < kPlainLightRounds ? 0 : rest[k] / tail;
    const SplineShares shares(field_, canvas_.x[k], canvas_.y[k]);
    const float w = weights[k] / (1 + size * size);
    sums.add(shares, w, 1, 0, 0, rest[k], 0, field_.columns);
    weight += w;
  }
  const float mean = static_cast<float>(weight) / static_cast<float>(sums.a11.size());
  stepField(sums, {kLightStiffness * mean, 0}, channel, channel, &field_);
}

void LightFit::center() {
  double mean[3] = {0, 0, 0}, count = 0;
  float values[3];
  for (std::size_t k = 0; k < canvas_.size(); ++k) {
    if (!canvas_.seen[k]) continue;
    field_.at(canvas_.x[k], canvas_.y[k], values);
    for (int c = 0; c < 3; ++c) mean[c] += values[c];
    ++count;
  }
  for (std::size_t k = 0; k < field_.nodes.size(); ++k)
    field_.nodes[k] -= static_cast<float>(mean[k % 3] / std::max(count, 1.0));
}

}  // namespace seamwise
