#include "photo/lattice/lattice_fit.h"

#include <algorithm>
#include <cmath>

namespace seamwise {
namespace {

constexpr double kTiltSpread = 0.2;    // tangent of 15 degrees at an f of 24 mm; chosen
constexpr double kLensSpread = 0.015;  // lenses of phones; chosen
constexpr double kPatchSamples = 20;   // samples that vary together by blur and folds; measured
constexpr double kLargestStep = 0.1;   // maximum change of the basis, as a share; chosen
constexpr int kLeastSamples = 8;       // along a cell
constexpr int kMostFitted = 40000;     // samples of all copies; more would not be more accurate

}  // namespace

FitStep linearised(const Copies& copies, const TiltedLattice& view) {
  constexpr int kUnknowns = 7;
  const CopiesMean mean = meanOf(copies);
  const std::size_t samples = copies.samples();
  const int n = copies.n;
  // Sums over copies, per sample and channel: w times derivative.
  std::vector<float> sums(samples * 3 * kUnknowns);
  std::array<double, 28> normal{};
  std::array<double, 7> gradient{};
  FitStep step;
  const float r = static_cast<float>(view.radius), lens = static_cast<float>(view.lens);
  const float tx = static_cast<float>(view.tilt.x()), ty = static_cast<float>(view.tilt.y());
  std::size_t at = 0;
  for (const auto& cell : copies.cells) {
    for (int b = 0; b < n; ++b) {
      std::array<float, 28> row_normal{};
      std::array<float, 7> row_gradient{};
      float row_sum = 0;
      for (int a = 0; a < n; ++a, ++at) {
        const float w = copies.weights[at];
        const int s = b * n + a;
        if (w == 0) continue;
        const double u = cell[0] + (a + 0.5) / n, v = cell[1] + (b + 0.5) / n;
        const Vec2 q = view.basis * Vec2(u, v) + view.origin;
        const float qx = static_cast<float>(q.x()), qy = static_cast<float>(q.y());
        const float z = 1 / (1 + tx * qx + ty * qy), px = qx * z, py = qy * z;
        const float square = px * px + py * py;
        for (int c = 0; c < 3; ++c) {
          const float gx = r * copies.slopes_x[4 * at + c], gy = r * copies.slopes_y[4 * at + c];
          const float along = gx * px + gy * py;
          // The chain rule goes back through the lens, then through the tilt.
          const float ex = (1 + lens * square) * gx + 2 * lens * along * px;
          const float ey = (1 + lens * square) * gy + 2 * lens * along * py;
          const float inward = (ex * px + ey * py) * z;
          const float fx = ex * z - inward * tx, fy = ey * z - inward * ty;
          const float fu = static_cast<float>(u), fv = static_cast<float>(v);
          const std::array<float, 7> d{fx * fu,      fx * fv,      fy * fu,       fy * fv,
                                       -inward * qx, -inward * qy, square * along};
          const float e = copies.values[4 * at + c] - mean.values[4 * s + c];
          float* sum = &sums[(s * 3 + c) * kUnknowns];
          int k = 0;
          for (int i = 0; i < kUnknowns; ++i) {
            const float wd = w * d[i];
            sum[i] += wd;
            row_gradient[i] += wd * e;
            for (int j = 0; j <= i; ++j) row_normal[k++] += wd * d[j];
          }
          row_sum += w * e * e;
        }
        step.count += w;
      }
      for (int k = 0; k < 28; ++k) normal[k] += row_normal[k];
      for (int k = 0; k < kUnknowns; ++k) gradient[k] += row_gradient[k];
      step.sum += row_sum;
    }
  }
  for (std::size_t s = 0; s < samples; ++s) {
    if (mean.weights[s] == 0) continue;
    step.count -= 1;
    for (int c = 0; c < 3; ++c) {
      const float* sum = &sums[(s * 3 + c) * kUnknowns];
      int k = 0;
      for (int i = 0; i < kUnknowns; ++i)
        for (int j = 0; j <= i; ++j) normal[k++] -= sum[i] * sum[j] / mean.weights[s];
    }
  }
  int k = 0;
  for (int i = 0; i < kUnknowns; ++i)
    for (int j = 0; j <= i; ++j) step.normal[i][j] = step.normal[j][i] = normal[k++];
  step.gradient = gradient;
  return step;
}

void downweigh(Copies& copies) {
  const CopiesMean mean = meanOf(copies);
  const std::size_t samples = copies.samples();
  std::vector<float> errors(copies.weights.size());
  double sum = 0, count = 0;
  std::size_t at = 0;
  for (std::size_t c = 0; c < copies.cells.size(); ++c) {
    for (std::size_t s = 0; s < samples; ++s, ++at) {
      if (copies.weights[at] == 0 || mean.weights[s] < 1.5F) continue;
      const ChannelImage::Pixel e = loaded(&copies.values[4 * at]) - loaded(&mean.values[4 * s]);
      const float others = mean.weights[s] / (mean.weights[s] - 1);
      errors[at] = others * std::sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
      sum += errors[at], ++count;
    }
  }
  if (sum == 0) return;
  const float scale = static_cast<float>(count / (3 * sum));
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const float share = errors[i] * scale;
    copies.weights[i] *= 1 / (1 + share * share);
  }
}

const ChannelImage& levelFor(const std::vector<ChannelImage>& levels, const TiltedLattice& view,
                             int n) {
  const double side = view.radius * std::sqrt(std::abs(view.basis.determinant()));
  std::size_t level = 0;
  while (level + 1 < levels.size() && side * levels[level].scale > 1.7 * n) ++level;
  return levels[level];
}

bool LatticeFit::advance() {
  if (stage_ == stages_.size()) return false;
  const FitStage& stage = stages_[stage_];
  const bool goes_on = step(stage);
  if (++step_ == stage.steps || !goes_on) ++stage_, step_ = 0;
  return stage_ < stages_.size();
}

/// Runs one step; returns false if the next one would not move anything.
bool LatticeFit::step(const FitStage& stage) {
  TiltedLattice& view = fitted_.view;
  CellList cells = visibleCells(view, stage.reach);
  if (cells.empty()) return false;
  const double room =
      std::sqrt(static_cast<double>(kMostFitted) / static_cast<double>(cells.size()));
  const int n = std::clamp(static_cast<int>(room), kLeastSamples, stage.n);
  const double most = std::max(std::abs(cells.front()[1]), std::abs(cells.back()[1])) + 1.0;
  Copies copies = sampleCopies(levelFor(levels_, view, n), view, std::move(cells), n, true);
  downweigh(copies);
  FitStep step = linearised(copies, view);
  // Prior knowledge preserves parameters that the image does not determine.
  const double unit = step.sum / std::max(1.0, step.count) * kPatchSamples;
  if (!(unit > 0)) return false;
  for (int i = 0; i < 4; ++i) step.normal[i][i] += unit / view.basis.squaredNorm();
  for (int i = 4; i < 6; ++i) {
    step.normal[i][i] += unit / (kTiltSpread * kTiltSpread);
    step.gradient[i] += view.tilt[i - 4] * unit / (kTiltSpread * kTiltSpread);
  }
  step.normal[6][6] += unit / (kLensSpread * kLensSpread);
  step.gradient[6] += view.lens * unit / (kLensSpread * kLensSpread);
  NormalMatrix inverse{};
  const int count = static_cast<int>(stage.unknowns);
  if (!invertNormal(step.normal, count, inverse)) return false;
  std::array<double, 7> move{};
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j) move[i] -= inverse[i][j] * step.gradient[j];
  const Mat2 change = (Mat2() << move[0], move[1], move[2], move[3]).finished();
  const Vec2 tilt_change(move[4], move[5]);
  const double size = (view.basis.inverse() * change).norm() + tilt_change.norm() / 2;
  const double damp = size > kLargestStep ? kLargestStep / size : 1;
  for (int column = 0; column < 2; ++column) {
    const Vec2 w = view.basis.col(column);
    double along = 0;
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) along += w[i] * w[j] * inverse[2 * i + column][2 * j + column];
    fitted_.uncertainty[column] = std::sqrt(along * unit) / w.squaredNorm();
  }
  view.basis += damp * change;
  view.tilt += damp * tilt_change;
  view.lens += damp * move[6];
  return size * most * n > 0.02;
}

}  // namespace seamwise
