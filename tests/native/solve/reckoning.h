#pragma once
// Recalculates mismatches from a result's shapes and alignments alone.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "solve/result.h"
#include "wallpaper/group.h"

namespace seamwise::testing {

/// An independent calculation of the figures: elements come straight from the table of groups, and
/// lattice shifts from trying all around the nearest.
class Reckoning {
 public:
  /// @param continuous_only   excludes mirrors and glides
  explicit Reckoning(const Result& r, bool continuous_only = false) : r_(r) {
    basis_ << r.w1, r.w2;
    for (const LatticeElement& e : cosets(*findGroup(r.group))) {
      if (continuous_only && e.det() < 0) continue;
      const Mat2 m = (Mat2() << e.m[0], e.m[1], e.m[2], e.m[3]).finished();
      linear_.push_back(basis_ * m * inverse());
      shift_.push_back(basis_ * Vec2(e.a[0], e.a[1]));
    }
  }

  double fit(const Shapes& shapes, const std::vector<Alignment>& at, bool strict = false) const {
    double total = 0;
    eachSeam([&](const Seam& s) {
      for (std::size_t i = 0; i + 1 < s.a.vertices.size(); ++i) {
        const Edge a = edge(s.a, i, shapes, at), b = edge(s.b, i, shapes, at);
        std::vector<double> turns, distances;
        for (std::size_t k = 0; k < linear_.size(); ++k) {
          turns.push_back(std::acos(std::clamp(
              a.direction.normalized().dot((linear_[k] * b.direction).normalized()), -1.0, 1.0)));
          distances.push_back(shortest(a.middle - linear_[k] * b.middle - shift_[k]));
        }
        const double limit = *std::min_element(turns.begin(), turns.end()) + 0.1;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < turns.size(); ++k)
          if (!strict || turns[k] <= limit) least = std::min(least, distances[k]);
        total += (a.direction.norm() + b.direction.norm()) / 2 * least;
      }
    });
    return total;
  }

  /// Length of the seams whose mismatch exceeds `cm`. [cm]
  double lengthOver(double cm) const {
    double total = 0;
    eachSeam([&](const Seam& s) {
      for (std::size_t i = 0; i + 1 < s.a.vertices.size(); ++i) {
        const Edge a = edge(s.a, i, r_.shapes, r_.alignment);
        const Edge b = edge(s.b, i, r_.shapes, r_.alignment);
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < linear_.size(); ++k)
          least = std::min(least, shortest(a.middle - linear_[k] * b.middle - shift_[k]));
        if (least > cm) total += (a.direction.norm() + b.direction.norm()) / 2;
      }
    });
    return total;
  }

  double seamFit(const Shapes& shapes, const std::vector<Alignment>& at) const {
    double total = 0;
    eachSeam([&](const Seam& s) {
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < linear_.size(); ++k) {
        const std::size_t n = s.a.vertices.size() - 1;
        const Edge a0 = edge(s.a, n / 2, shapes, at), b0 = edge(s.b, n / 2, shapes, at);
        const Vec2 cell = inverse() * (a0.middle - linear_[k] * b0.middle - shift_[k]);
        for (int u = -3; u <= 3; ++u) {
          for (int v = -3; v <= 3; ++v) {
            const Vec2 shift = basis_ * Vec2(std::round(cell.x()) + u, std::round(cell.y()) + v);
            double cost = 0;
            for (std::size_t i = 0; i < n; ++i) {
              const Edge a = edge(s.a, i, shapes, at), b = edge(s.b, i, shapes, at);
              cost += (a.direction.norm() + b.direction.norm()) / 2 *
                      (a.middle - linear_[k] * b.middle - shift_[k] - shift).norm();
            }
            least = std::min(least, cost);
          }
        }
      }
      total += least;
    });
    return total;
  }

 private:
  struct Edge {
    Vec2 middle, direction;
  };

  Mat2 inverse() const {
    const double det = cross(basis_.col(0), basis_.col(1));
    return (Mat2() << basis_(1, 1), -basis_(0, 1), -basis_(1, 0), basis_(0, 0)).finished() / det;
  }
  double shortest(const Vec2& v) const {
    const Vec2 c = inverse() * v;
    double least = std::numeric_limits<double>::infinity();
    for (int i = -2; i <= 2; ++i)
      for (int j = -2; j <= 2; ++j)
        least = std::min(least,
                         (v - basis_ * Vec2(std::round(c.x()) + i, std::round(c.y()) + j)).norm());
    return least;
  }
  void eachSeam(const std::function<void(const Seam&)>& visit) const {
    for (const Seam& s : r_.pattern.seams)
      if (s.matched && !s.twin) visit(s);
  }
  Edge edge(const SeamSide& s, std::size_t i, const Shapes& shapes,
            const std::vector<Alignment>& at) const {
    const Vec2 from = at[s.piece].toPrint(shapes[s.piece][s.vertices[i]]);
    const Vec2 to = at[s.piece].toPrint(shapes[s.piece][s.vertices[i + 1]]);
    return {(from + to) / 2, to - from};
  }

  const Result& r_;
  Mat2 basis_;
  std::vector<Mat2> linear_;
  std::vector<Vec2> shift_;
};

}  // namespace seamwise::testing
