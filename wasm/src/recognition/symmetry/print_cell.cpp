#include "recognition/symmetry/print_cell.h"

#include <algorithm>
#include <cmath>

#include "wallpaper/group.h"

namespace seamwise {
namespace {

/// Weights of four neighbouring samples at a share t between the middle two [Keys 1981].
std::array<float, 4> cubicWeights(double t) {
  const double u = 1 - t;
  return {static_cast<float>(-0.5 * t * u * u), static_cast<float>(1 + t * t * (1.5 * t - 2.5)),
          static_cast<float>(1 + u * u * (1.5 * u - 2.5)), static_cast<float>(-0.5 * u * t * t)};
}

/// Samples of a cell that repeats, and their weights, for one place in it.
class CellPlace {
 public:
  CellPlace(const CellPicture& cell, const Vec2& u) : n_(cell.n) {
    const Vec2 p = u * n_;
    const Vec2 first(std::floor(p.x() + kRounding), std::floor(p.y() + kRounding));
    across_ = cubicWeights(std::max(0.0, p.x() - first.x()));
    up_ = cubicWeights(std::max(0.0, p.y() - first.y()));
    for (int k = 0; k < 4; ++k) {
      columns_[k] = wrapped(first.x() + k - 1);
      rows_[k] = wrapped(first.y() + k - 1);
    }
  }
  float of(const std::vector<float>& plane) const {
    float sum = 0;
    for (int j = 0; j < 4; ++j) {
      const float* const row = plane.data() + static_cast<std::size_t>(rows_[j]) * n_;
      float along = 0;
      for (int i = 0; i < 4; ++i) along += across_[i] * row[columns_[i]];
      sum += up_[j] * along;
    }
    return sum;
  }
  float nearestOf(const std::vector<float>& plane) const {
    return plane[static_cast<std::size_t>(rows_[1]) * n_ + columns_[1]];
  }

 private:
  /// Places that rounding alone keeps from a sample are that sample. [samples]
  static constexpr double kRounding = 1e-7;

  int wrapped(double k) const {
    const int whole = static_cast<int>(k) % n_;
    return whole < 0 ? whole + n_ : whole;
  }

  int n_;
  std::array<float, 4> across_, up_;
  std::array<int, 4> columns_, rows_;
};

float clampedColour(float c) { return std::clamp(c, 0.0f, 1.0f); }

CellPicture emptyCell(int n) {
  CellPicture cell;
  cell.n = n;
  for (auto& plane : cell.planes) plane.assign(static_cast<std::size_t>(n) * n, 0.0f);
  cell.noise.assign(static_cast<std::size_t>(n) * n, 0.0f);
  return cell;
}

/// Adds a share of the cell's image under u -> m u + a, whose samples are those of the cell.
void addImage(const CellPicture& cell, const LatticeElement& e, float share, CellPicture& sum) {
  const int n = cell.n;
  const int a1 = static_cast<int>(std::lround(e.a[0] * n));
  const int a2 = static_cast<int>(std::lround(e.a[1] * n));
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int column = (((e.m[0] * i + e.m[1] * j + a1) % n) + n) % n;
      const int row = (((e.m[2] * i + e.m[3] * j + a2) % n) + n) % n;
      const std::size_t from = static_cast<std::size_t>(row) * n + column;
      const std::size_t to = static_cast<std::size_t>(j) * n + i;
      for (int c = 0; c < 3; ++c) sum.planes[c][to] += share * cell.planes[c][from];
      sum.noise[to] += share * share * cell.noise[from];
    }
  }
}

/// Each sample the mean of all along w2.
void evenAlongStripes(CellPicture& cell) {
  const int n = cell.n;
  for (auto& plane : cell.planes) {
    for (int i = 0; i < n; ++i) {
      float sum = 0;
      for (int j = 0; j < n; ++j) sum += plane[static_cast<std::size_t>(j) * n + i];
      for (int j = 0; j < n; ++j) {
        plane[static_cast<std::size_t>(j) * n + i] = sum / static_cast<float>(n);
      }
    }
  }
}

}  // namespace

CellPicture rebased(const CellPicture& cell, const GroupVerdict& verdict) {
  CellPicture out = emptyCell(cell.n + cell.n % 2);
  const std::array<int, 4>& b = verdict.basis;
  const Mat2 basis = (Mat2() << b[0], b[1], b[2], b[3]).finished();
  for (int j = 0; j < out.n; ++j) {
    for (int i = 0; i < out.n; ++i) {
      const CellPlace place(cell, basis * (Vec2(i, j) / out.n) + verdict.origin);
      const std::size_t at = static_cast<std::size_t>(j) * out.n + i;
      for (int c = 0; c < 3; ++c) out.planes[c][at] = clampedColour(place.of(cell.planes[c]));
      out.noise[at] = place.nearestOf(cell.noise);
    }
  }
  return out;
}

CellPicture symmetrised(const CellPicture& cell, const GroupVerdict& verdict, bool stripes) {
  CellPicture own = rebased(cell, verdict);
  if (stripes) evenAlongStripes(own);
  CellPicture sum = emptyCell(own.n);
  const std::vector<LatticeElement> elements = cosets(*verdict.group);
  const float share = 1 / static_cast<float>(elements.size());
  for (const LatticeElement& e : elements) addImage(own, e, share, sum);
  return sum;
}

Picture printPicture(const CellPicture& cell, const Mat2& sides, const Vec2& corner, int width,
                     int height) {
  Picture picture;
  picture.width = width;
  picture.height = height;
  for (auto& plane : picture.planes) plane.resize(static_cast<std::size_t>(width) * height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Vec2 share((x + 0.5) / width, 1 - (y + 0.5) / height);
      const CellPlace place(cell, corner + sides * share);
      const std::size_t at = static_cast<std::size_t>(y) * width + x;
      for (int c = 0; c < 3; ++c) {
        picture.planes[c][at] = clampedColour(place.of(cell.planes[c]));
      }
    }
  }
  return picture;
}

}  // namespace seamwise
