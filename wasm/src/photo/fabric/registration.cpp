#include "photo/fabric/registration.h"

#include <algorithm>
#include <cmath>

namespace seamwise {

namespace {
constexpr int kCoarseShiftRounds = 3, kShiftRounds = 8;
constexpr double kShiftNodesPerCell = 3;
constexpr double kMostShiftNodesAcross = 72;  // nodes along the longer side
constexpr float kShiftStiffness = 0.05f;      // share of a node's mean curvature
constexpr float kShiftSize = 0.003f;  // share of it; nothing else holds a node along stripes
constexpr float kShiftTail = 3;       // errors beyond this many mean errors count little

/// Converts derivatives by u and v at a sample to derivatives by x and y on the image.
struct PictureSlopes {
  PictureSlopes(const LatticeCanvas& canvas, int column, int row) {
    const int left = column > 0 ? 1 : 0, right = column + 1 < canvas.columns() ? 1 : 0;
    const int down = row > 0 ? 1 : 0, up = row + 1 < canvas.rows() ? 1 : 0;
    const int k = row * canvas.columns() + column;
    const float along = static_cast<float>(canvas.n) / static_cast<float>(left + right);
    const float across = static_cast<float>(canvas.n) / static_cast<float>(down + up);
    const int above = k + up * canvas.columns(), below = k - down * canvas.columns();
    const float xu = (canvas.x[k + right] - canvas.x[k - left]) * along;
    const float yu = (canvas.y[k + right] - canvas.y[k - left]) * along;
    const float xv = (canvas.x[above] - canvas.x[below]) * across;
    const float yv = (canvas.y[above] - canvas.y[below]) * across;
    const float det = xu * yv - yu * xv;
    ux = yv / det, vx = -yu / det, uy = -xv / det, vy = xu / det;
  }
  float ux, vx, uy, vy;
};
}  // namespace

CopyRegistration::CopyRegistration(LatticeCanvas canvas, const PixelView& pixels, int factor,
                                   const PixelView& coarse, int coarse_factor,
                                   const SmoothField& light, const SrgbCurve& curve, int width,
                                   int height, double cell_size)
    : canvas_(std::move(canvas)),
      pixels_(pixels),
      coarse_(coarse),
      factor_(factor),
      coarse_factor_(coarse_factor),
      curve_(curve),
      shift_(2, width, height,
             std::max(cell_size / kShiftNodesPerCell,
                      std::max(width, height) / kMostShiftNodesAcross)) {
  for (std::vector<float>& gains : gains_) gains.resize(canvas_.size());
  float values[3];
  for (std::size_t k = 0; k < canvas_.size(); ++k) {
    if (!canvas_.seen[k]) continue;
    light.at(canvas_.x[k], canvas_.y[k], values);
    for (int c = 0; c < 3; ++c) gains_[c][k] = std::exp(-values[c]);
  }
}

bool CopyRegistration::advance() {
  is_sampled_ = !is_sampled_;
  if (is_sampled_) {
    sample();
    return true;
  }
  average();
  if (++round_ > kShiftRounds) return false;  // the last round samples the final field
  step();
  center();
  return true;
}

void CopyRegistration::sample() {
  const bool coarse = round_ < kCoarseShiftRounds;
  sampleCanvas(coarse ? coarse_ : pixels_, coarse ? coarse_factor_ : factor_, shift_, &canvas_);
  for (int c = 0; c < 3; ++c) {
    std::vector<float>& plane = canvas_.planes[c];
    for (std::size_t k = 0; k < plane.size(); ++k)
      if (canvas_.seen[k]) plane[k] = curve_.code(curve_.linear(plane[k]) * gains_[c][k]);
  }
}

void CopyRegistration::average() {
  const std::size_t places = static_cast<std::size_t>(canvas_.n) * canvas_.n;
  count_.assign(places, 0);
  for (std::vector<float>& plane : mean_) plane.assign(places, 0);
  for (int b = 0, k = 0; b < canvas_.rows(); ++b) {
    for (int a = 0; a < canvas_.columns(); ++a, ++k) {
      if (!canvas_.seen[k]) continue;
      const std::size_t place = canvas_.place(a, b);
      ++count_[place];
      for (int c = 0; c < 3; ++c) mean_[c][place] += canvas_.planes[c][k];
    }
  }
  for (std::vector<float>& plane : mean_)
    for (std::size_t k = 0; k < places; ++k) plane[k] /= std::max(count_[k], 1.0f);
}

void CopyRegistration::step() {
  const int n = canvas_.n;
  double errors = 0, used = 1e-9;
  for (int b = 0, k = 0; b < canvas_.rows(); ++b) {
    for (int a = 0; a < canvas_.columns(); ++a, ++k) {
      if (!canvas_.seen[k]) continue;
      for (int c = 0; c < 3; ++c)
        errors += std::abs(mean_[c][canvas_.place(a, b)] - canvas_.planes[c][k]);
      ++used;
    }
  }
  const float tail = kShiftTail * static_cast<float>(errors / used) + 1e-6f;
  FieldSums sums(shift_);
  for (int b = 0, k = 0; b < canvas_.rows(); ++b) {
    const std::size_t row = static_cast<std::size_t>(b % n) * n;
    const std::size_t above = static_cast<std::size_t>((b + 1) % n) * n;
    const std::size_t below = static_cast<std::size_t>((b + n - 1) % n) * n;
    for (int a = 0; a < canvas_.columns(); ++a, ++k) {
      const std::size_t place = row + a % n;
      if (!canvas_.seen[k] || count_[place] < 2) continue;
      const PictureSlopes to(canvas_, a, b);
      const SplineShares shares(shift_, canvas_.x[k], canvas_.y[k]);
      // The mean of the other copies counts, because a copy must not hold itself back.
      const float others = count_[place] / (count_[place] - 1);
      float difference = 0, error[3];
      for (int c = 0; c < 3; ++c) {
        error[c] = others * (mean_[c][place] - canvas_.planes[c][k]);
        difference += std::abs(error[c]);
      }
      const float size = difference / tail, weight = 1 / (1 + size * size);
      float gx2 = 0, gxy = 0, gy2 = 0, ex = 0, ey = 0;
      for (int c = 0; c < 3; ++c) {
        const std::vector<float>& t = mean_[c];
        const float half = 0.5f * static_cast<float>(n);
        const float tu = half * (t[row + (a + 1) % n] - t[row + (a + n - 1) % n]);
        const float tv = half * (t[above + a % n] - t[below + a % n]);
        const float gx = to.ux * tu + to.vx * tv, gy = to.uy * tu + to.vy * tv;
        gx2 += gx * gx, gxy += gx * gy, gy2 += gy * gy;
        ex += gx * error[c], ey += gy * error[c];
      }
      sums.add(shares, weight, gx2, gxy, gy2, ex, ey, shift_.columns);
    }
  }
  double curvature = 0;
  for (std::size_t k = 0; k < sums.a11.size(); ++k) curvature += sums.a11[k] + sums.a22[k];
  const float mean = static_cast<float>(curvature) / (2 * static_cast<float>(sums.a11.size()));
  stepField(sums, {kShiftStiffness * mean, kShiftSize * mean}, 0, 1, &shift_);
}

void CopyRegistration::center() {
  double mean[2] = {0, 0}, count = 1e-9;
  float d[2];
  for (std::size_t k = 0; k < canvas_.size(); ++k) {
    if (!canvas_.seen[k]) continue;
    shift_.at(canvas_.x[k], canvas_.y[k], d);
    mean[0] += d[0], mean[1] += d[1];
    ++count;
  }
  for (std::size_t k = 0; k < shift_.nodes.size(); ++k)
    shift_.nodes[k] -= static_cast<float>(mean[k % 2] / count);
}

double CopyRegistration::rms() const {
  double sum = 0, count = 1e-9;
  float d[2];
  for (std::size_t k = 0; k < canvas_.size(); ++k) {
    if (!canvas_.seen[k]) continue;
    shift_.at(canvas_.x[k], canvas_.y[k], d);
    sum += static_cast<double>(d[0]) * d[0] + static_cast<double>(d[1]) * d[1];
    ++count;
  }
  return std::sqrt(sum / count);
}

}  // namespace seamwise
