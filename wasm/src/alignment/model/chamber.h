#pragma once
#include <cstdint>
#include <vector>

#include "base/lanes.h"
#include "wallpaper/group.h"

namespace seamwise {

/// A chamber of the plane, which the mirrors of a print divide. Folding along the mirrors carries
/// every point into one chamber. The distance between two orbits of the mirrors' subgroup is that
/// of the two folded points, without a search for the nearest image (Humphreys, Reflection groups
/// and Coxeter groups, 1990, 4.3). The whole group requires as many points as the subgroup has
/// cosets: 1 in pm, pmm, p4m, p3m1 and p6m, 2 in cm, cmm and pmg, 3 in p31m, 4 in p4g.
struct Chamber {
  enum class Shape : std::uint8_t {
    kCell,         ///< no mirrors, no folding; all other fields are unset
    kStrip,        ///< between parallel mirrors, one repeat long
    kRectangle,    ///< mirrors at right angles
    kHalfSquare,   ///< also mirrors at 45 degrees
    kEquilateral,  ///< mirrors at 60 degrees
    kHalfEquilateral
  };
  Shape shape = Shape::kCell;
  /// Map from the print, in cm, to coordinates of the chamber: p -> to p + offset.
  Mat2 to = Mat2::Identity();
  Vec2 offset = Vec2::Zero();
  /// Squares of the coordinates' units. A triangle's three coordinates, which add up to 0, use
  /// the first one. [cm2]
  double square0 = 1, square1 = 1;
  /// One element of each coset of the mirrors' subgroup, in these coordinates: p -> m p + a. The
  /// first is the identity.
  struct Coset {
    Mat2 m = Mat2::Identity();
    Vec2 a = Vec2::Zero();
  };
  std::vector<Coset> cosets;

  static bool isTriangle(Shape shape) {
    return shape == Shape::kEquilateral || shape == Shape::kHalfEquilateral;
  }

  /// The chamber of a group; a cell if it has no mirrors.
  static Chamber of(const WallpaperGroup& group);
};

/// The point of a chamber to which its mirrors carry (x, y). `V` is a number or a vector of
/// several.
/// @tparam triangle   true for the equilateral shapes
template <bool triangle, class V>
struct Folded {
  V x, y;
  [[gnu::always_inline]] Folded(Chamber::Shape shape, const V& at_x, const V& at_y)
      : x(at_x), y(at_y) {
    using internal::roundNear;
    if constexpr (triangle) {
      foldIntoTriangle(shape == Chamber::Shape::kHalfEquilateral);
    } else {
      x = abs(V(x - roundNear(x)));
      if (shape == Chamber::Shape::kStrip) return;
      y = abs(V(y - roundNear(y)));
      if (shape == Chamber::Shape::kHalfSquare) sort(x, y);
    }
  }

  /// Square of the distance to another point of the chamber, for the units `square0` and `square1`.
  /// [cm2]
  template <class Real>
  [[gnu::always_inline]] V squaredTo(const Folded& other, Chamber::Shape shape, Real square0,
                                     Real square1) const {
    V s = x - other.x, t = y - other.y;
    if constexpr (triangle) {
      const V u = s + t;
      return (s * s + t * t + u * u) * square0;
    } else {
      if (shape == Chamber::Shape::kStrip) t -= internal::roundNear(t);
      return s * s * square0 + t * t * square1;
    }
  }

 private:
  [[gnu::always_inline]] static void sort(V& greater, V& smaller) {
    const V g = greatest(greater, smaller);
    smaller = least(greater, smaller), greater = g;
  }

  /// The coordinates are x, y and z = -x - y; mirrors are where two of them differ by a whole
  /// number. Translations are whole numbers that add up to 0. Remainders of rounding add up to -1,
  /// 0 or 1: the one that was rounded furthest makes up for it. The mirrors through 0 then sort
  /// them.
  [[gnu::always_inline]] void foldIntoTriangle(bool half) {
    using internal::roundNear;
    V z = -x - y;
    x -= roundNear(x), y -= roundNear(y), z -= roundNear(z);
    sort(x, y), sort(y, z), sort(x, y);
    const V excess = roundNear(V(x + y + z)), none = x - x;
    const auto over = excess > none, under = excess < none;
    const V first = over ? y : under ? z + 1 : x, second = over ? z : under ? x : y;
    x = first, y = second;
    if (!half) return;
    const auto beyond = y > none;  // half a turn: -z, -y, -x
    const V turned = beyond ? x + y : x;
    y = beyond ? -y : y, x = turned;
  }
};

}  // namespace seamwise
