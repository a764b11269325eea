#include "photo/fabric/smooth_field.h"

#include <algorithm>
#include <cmath>

namespace seamwise {

namespace {

constexpr int kFieldSolveSteps = 60;   // conjugate gradients; errors fall below 1e-3 of the step
constexpr float kFieldSolved = 1e-8f;  // share of the residual's square
constexpr float kLeastFieldCurvature = 1e-6f;  // keeps unobserved nodes from being singular

void cubicSplineShares(float t, float* shares) {
  const float s = 1 - t;
  shares[0] = s * s * s / 6;
  shares[1] = (4 - 6 * t * t + 3 * t * t * t) / 6;
  shares[2] = (4 - 6 * s * s + 3 * s * s * s) / 6;
  shares[3] = t * t * t / 6;
}

/// Adds stiffness times the derivative of (x1 - 2 x2 + x3)^2 / 2.
void addSecondDifference(const float* x, float stiffness, std::size_t a, std::size_t b,
                         std::size_t c, float* out) {
  const float bend = stiffness * (x[a] - 2 * x[b] + x[c]);
  out[a] += bend;
  out[b] -= 2 * bend;
  out[c] += bend;
}

/// Adds the derivative of half the thin-plate energy of a grid of values.
void addBending(const float* x, int columns, int rows, float stiffness, float* out) {
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const std::size_t k = static_cast<std::size_t>(j) * columns + i;
      if (i + 2 < columns) addSecondDifference(x, stiffness, k, k + 1, k + 2, out);
      if (j + 2 < rows) addSecondDifference(x, stiffness, k, k + columns, k + 2 * columns, out);
      if (i + 1 >= columns || j + 1 >= rows) continue;
      const float twist = 2 * stiffness * (x[k] - x[k + 1] - x[k + columns] + x[k + columns + 1]);
      out[k] += twist;
      out[k + 1] -= twist;
      out[k + columns] -= twist;
      out[k + columns + 1] += twist;
    }
  }
}

double dotOf(const std::vector<float>& a, const std::vector<float>& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += static_cast<double>(a[k]) * b[k];
  return sum;
}

/// Computes (A + bending + size) x for both channels, stored one after the other in x.
void applyNormal(const FieldSums& sums, const FieldCost& cost, int columns, int rows,
                 const std::vector<float>& x, std::vector<float>* out) {
  const std::size_t n = sums.a11.size();
  const float least = cost.size + kLeastFieldCurvature;
  for (std::size_t k = 0; k < n; ++k) {
    (*out)[k] = (sums.a11[k] + least) * x[k] + sums.a12[k] * x[n + k];
    (*out)[n + k] = sums.a12[k] * x[k] + (sums.a22[k] + least) * x[n + k];
  }
  addBending(x.data(), columns, rows, cost.bending, out->data());
  addBending(x.data() + n, columns, rows, cost.bending, out->data() + n);
}

}  // namespace

SmoothField::SmoothField(int count, double width, double height, double spacing)
    : channels(count),
      columns(static_cast<int>(std::ceil(width / spacing)) + 3),
      rows(static_cast<int>(std::ceil(height / spacing)) + 3),
      step(spacing),
      nodes(static_cast<std::size_t>(columns) * rows * count) {}

SplineShares::SplineShares(const SmoothField& field, float x, float y) {
  const float per_px = 1 / static_cast<float>(field.step);
  const float s = std::clamp(x * per_px, 0.0f, static_cast<float>(field.columns - 3));
  const float t = std::clamp(y * per_px, 0.0f, static_cast<float>(field.rows - 3));
  const int i = std::min(static_cast<int>(s), field.columns - 4);
  const int j = std::min(static_cast<int>(t), field.rows - 4);
  first = j * field.columns + i;
  cubicSplineShares(s - static_cast<float>(i), across);
  cubicSplineShares(t - static_cast<float>(j), down);
}

void SmoothField::at(float x, float y, float* values) const {
  const SplineShares shares(*this, x, y);
  for (int c = 0; c < channels; ++c) values[c] = 0;
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) {
      const float share = shares.across[i] * shares.down[j];
      const float* node = nodes.data() + (shares.first + j * columns + i) * channels;
      for (int c = 0; c < channels; ++c) values[c] += share * node[c];
    }
  }
}

FieldSums::FieldSums(const SmoothField& field) {
  const std::size_t n = static_cast<std::size_t>(field.columns) * field.rows;
  for (std::vector<float>* sum : {&a11, &a12, &a22, &g1, &g2}) sum->assign(n, 0);
}

void FieldSums::add(const SplineShares& at, float weight, float xx, float xy, float yy, float gx,
                    float gy, int columns) {
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) {
      const float w = weight * at.across[i] * at.down[j];
      const std::size_t k = at.first + j * columns + i;
      a11[k] += w * xx;
      a12[k] += w * xy;
      a22[k] += w * yy;
      g1[k] += w * gx;
      g2[k] += w * gy;
    }
  }
}

void stepField(const FieldSums& sums, const FieldCost& cost, int c1, int c2, SmoothField* field) {
  const std::size_t n = sums.a11.size();
  std::vector<float> x(2 * n), now(2 * n), residual(2 * n), direction, image(2 * n);
  for (std::size_t k = 0; k < n; ++k) {
    now[k] = -field->nodes[k * field->channels + c1];
    now[n + k] = -field->nodes[k * field->channels + c2];
    residual[k] = sums.g1[k] + cost.size * now[k];
    residual[n + k] = sums.g2[k] + cost.size * now[n + k];
  }
  addBending(now.data(), field->columns, field->rows, cost.bending, residual.data());
  addBending(now.data() + n, field->columns, field->rows, cost.bending, residual.data() + n);
  direction = residual;
  double squared = dotOf(residual, residual);
  const double enough = squared * kFieldSolved;
  for (int step = 0; step < kFieldSolveSteps && squared > enough; ++step) {
    applyNormal(sums, cost, field->columns, field->rows, direction, &image);
    const float along = static_cast<float>(squared / std::max(dotOf(direction, image), 1e-30));
    for (std::size_t k = 0; k < 2 * n; ++k) {
      x[k] += along * direction[k];
      residual[k] -= along * image[k];
    }
    const double next = dotOf(residual, residual);
    const float keep = static_cast<float>(next / squared);
    for (std::size_t k = 0; k < 2 * n; ++k) direction[k] = residual[k] + keep * direction[k];
    squared = next;
  }
  for (std::size_t k = 0; k < n; ++k) {
    field->nodes[k * field->channels + c1] += x[k];
    if (c2 != c1) field->nodes[k * field->channels + c2] += x[n + k];
  }
}

}  // namespace seamwise
