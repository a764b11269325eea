#pragma once
// Cells of random prints that have exactly the symmetries of their group in the table.
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "photo/base/cell_picture.h"
#include "wallpaper/group.h"

namespace seamwise::testing {

/// A print whose cell can be drawn in any basis and from any origin.
struct SamplePrint {
  WallpaperGroup group;
  struct Motif {
    Vec2 middle = Vec2::Zero();  ///< [cm]
    Vec2 along = Vec2::UnitX();  ///< half of its length, as a vector. [cm]
    double width = 1;            ///< half of its width. [cm]
    double bend = 0;             ///< bend of its middle line
    std::array<float, 3> ink{};
  };
  std::array<float, 3> ground{};
  std::vector<Motif> motifs;
};

/// View of a cell, with the traces that a photo leaves in it.
struct CellView {
  std::array<int, 4> basis{1, 0, 0, 1};  ///< the cell's w1, w2 as columns in the group's basis
  Vec2 origin = Vec2::Zero();            ///< origin of the cell, in the group's basis
  int n = 96;
  double displaced = 0;  ///< root mean square of crease displacement. [share of the cell's side]
  double blur = 0;       ///< length of the blur in one direction. [samples]
  double shade = 0;      ///< amplitude of the remaining uneven light
  double noise = 0;      ///< standard deviation, of each colour
};

inline double symmetric(seamwise::Random& random) { return 2 * random.uniform() - 1; }

inline SamplePrint samplePrint(const WallpaperGroup& group, seamwise::Random& random) {
  SamplePrint print{group, {}, {}};
  const auto ink = [&random] {
    std::array<float, 3> colour{};
    for (float& c : colour) c = static_cast<float>(0.1 + 0.85 * random.uniform());
    return colour;
  };
  print.ground = ink();
  std::array<std::array<float, 3>, 4> inks{ink(), ink(), ink(), ink()};
  const double area = cross(group.w1(), group.w2());
  const auto order = static_cast<double>(group.elements().size());
  const double side = std::sqrt(area / order);
  const int count = 3 + random.below(12);
  for (int k = 0; k < count; ++k) {
    SamplePrint::Motif motif;
    motif.middle = random.uniform() * group.w1() + random.uniform() * group.w2();
    motif.along = side * (0.06 + 0.3 * random.uniform()) * unit(2 * kPi * random.uniform());
    motif.width = motif.along.norm() * (0.25 + 0.6 * random.uniform());
    motif.bend = 0.8 * symmetric(random);
    motif.ink = inks[random.below(4)];
    print.motifs.push_back(motif);
  }
  return print;
}

/// Returns whether a motif covers a point: a leaf, pointed at one end, along a bent line.
inline bool covers(const SamplePrint::Motif& motif, const Vec2& p) {
  const double length = motif.along.norm();
  const Vec2 axis = motif.along / length;
  const double x = (p - motif.middle).dot(axis) / length;
  const double y = cross(axis, p - motif.middle) / motif.width - motif.bend * (1 - x * x);
  return x > -1 && x < 1 && std::abs(y) < std::sqrt(1 - x * x) * (1 - 0.5 * x) / 1.5;
}

/// Draws the print's cell with `times` x `times` points a sample.
inline CellPicture drawnCell(const SamplePrint& print, const CellView& view, int times = 3) {
  const int fine = times * view.n;
  Mat2 own, change;
  own << print.group.w1(), print.group.w2();
  change << view.basis[0], view.basis[1], view.basis[2], view.basis[3];
  const Mat2 cell = own * change, inverse = cell.inverse();
  const Vec2 start = own * view.origin;
  CellPicture picture;
  picture.n = fine;
  for (int c = 0; c < 3; ++c) picture.planes[c].assign(fine * fine, print.ground[c]);
  for (const SamplePrint::Motif& motif : print.motifs) {
    const double reach = motif.along.norm() + motif.width * 3;
    for (const Element& e : print.group.elements()) {
      const Vec2 middle = inverse * (e(motif.middle) - start);
      const Vec2 half(reach * inverse.row(0).norm(), reach * inverse.row(1).norm());
      const Mat2 back = e.A.transpose();
      const auto first = [&](int k) { return int(std::ceil((middle[k] - half[k]) * fine)); };
      const auto last = [&](int k) { return int(std::floor((middle[k] + half[k]) * fine)); };
      for (int j = first(1); j <= last(1); ++j) {
        for (int i = first(0); i <= last(0); ++i) {
          const Vec2 p = start + cell * Vec2(i, j) / fine;
          if (!covers(motif, back * (p - e.a))) continue;
          const int at = ((j % fine) + fine) % fine * fine + ((i % fine) + fine) % fine;
          for (int c = 0; c < 3; ++c) picture.planes[c][at] = motif.ink[c];
        }
      }
    }
  }
  return picture;
}

/// Turns the finely drawn cell into that of a photo, in n samples.
inline CellPicture photographedCell(const CellPicture& fine, const CellView& view,
                                    seamwise::Random& random) {
  const int times = fine.n / view.n, m = fine.n;
  struct Wave {
    Vec2 k, d;
    double phase;
  };
  std::vector<Wave> waves;
  for (int k = 0; k < 6; ++k) {
    waves.push_back({Vec2(random.below(5) - 2, random.below(5) - 2),
                     Vec2(symmetric(random), symmetric(random)), 2 * kPi * random.uniform()});
  }
  double power = 1e-12;
  for (const Wave& w : waves) power += w.d.squaredNorm() / 2;
  const double strength = view.displaced * m / std::sqrt(power);
  const Vec2 motion = view.blur * times * unit(2 * kPi * random.uniform());
  const Wave light{Vec2(random.below(3) - 1, random.below(3) - 1), Vec2::Zero(),
                   2 * kPi * random.uniform()};
  const auto gaussian = [&random] {
    double sum = -6;
    for (int k = 0; k < 12; ++k) sum += random.uniform();
    return sum;
  };
  CellPicture out;
  out.n = view.n;
  for (auto& plane : out.planes) plane.assign(view.n * view.n, 0);
  // sum over the opponent channels y, 0.7 (R - B), 0.7 (G - (R + B) / 2)
  const double sum_of_squares = 1.0 / 3 + 0.49 * 2 + 0.49 * 1.5;
  out.noise.assign(view.n * view.n, static_cast<float>(view.noise * view.noise * sum_of_squares));
  for (int j = 0; j < view.n; ++j) {
    for (int i = 0; i < view.n; ++i) {
      const Vec2 u = Vec2(i, j) / view.n;
      Vec2 moved = Vec2::Zero();
      for (const Wave& w : waves)
        moved += strength * std::cos(2 * kPi * w.k.dot(u) + w.phase) * w.d;
      const double bright = 1 + view.shade * std::cos(2 * kPi * light.k.dot(u) + light.phase);
      const int steps = view.blur > 0 ? 7 : 1;
      for (int c = 0; c < 3; ++c) {
        double sum = 0;
        for (int s = 0; s < steps; ++s) {
          const Vec2 p = times * Vec2(i, j) + moved + (s - (steps - 1) / 2) / 7.0 * motion;
          for (int y = 0; y < times; ++y) {
            for (int x = 0; x < times; ++x) {
              const double px = p.x() + x - (times - 1) / 2.0, py = p.y() + y - (times - 1) / 2.0;
              const int x0 = int(std::floor(px)), y0 = int(std::floor(py));
              const double fx = px - x0, fy = py - y0;
              const auto at = [&](int b, int a) {
                return fine.planes[c][((b % m) + m) % m * m + ((a % m) + m) % m];
              };
              sum += (1 - fy) * ((1 - fx) * at(y0, x0) + fx * at(y0, x0 + 1)) +
                     fy * ((1 - fx) * at(y0 + 1, x0) + fx * at(y0 + 1, x0 + 1));
            }
          }
        }
        const double mean = sum / (times * times * steps);
        out.planes[c][j * view.n + i] =
            static_cast<float>(bright * mean + (view.noise > 0 ? view.noise * gaussian() : 0));
      }
    }
  }
  return out;
}

/// A basis of the same lattice, not far from reduced, and any origin.
inline CellView anyView(seamwise::Random& random) {
  CellView view;
  static constexpr std::array<std::array<int, 4>, 8> kBases{{{1, 0, 0, 1},
                                                             {0, -1, 1, 0},
                                                             {-1, 0, 0, -1},
                                                             {0, 1, -1, 0},
                                                             {1, 1, 0, 1},
                                                             {1, 0, -1, 1},
                                                             {1, -1, 1, 0},
                                                             {0, -1, 1, 1}}};
  view.basis = kBases[random.below(8)];
  view.origin = {random.uniform(), random.uniform()};
  return view;
}

inline Mat2 gramOf(const SamplePrint& print, const CellView& view) {
  Mat2 own, change;
  own << print.group.w1(), print.group.w2();
  change << view.basis[0], view.basis[1], view.basis[2], view.basis[3];
  return (own * change).transpose() * (own * change);
}

}  // namespace seamwise::testing
