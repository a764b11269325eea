#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/lanes.h"
#include "base/outcome.h"
#include "geometry/rigid_motion.h"

namespace seamwise {

enum class LatticeType : std::uint8_t { kOblique, kRectangular, kRhombic, kSquare, kHexagonal };

/// Limits on the lengths of w1, w2 and the shortest repeat of a lattice. [cm]
inline constexpr double kShortestRepeat = 0.05, kLongestRepeat = 1000;

/// A short list with inline storage, so that tables of such lists are data and no code.
template <class T, std::size_t n>
class Few {
 public:
  constexpr Few(std::initializer_list<T> items) : size_(items.size()) {
    std::copy(items.begin(), items.end(), items_.begin());
  }
  constexpr const T* begin() const { return items_.data(); }
  constexpr const T* end() const { return items_.data() + size_; }
  constexpr bool empty() const { return size_ == 0; }
  constexpr std::size_t size() const { return size_; }
  constexpr const T& operator[](std::size_t k) const { return items_[k]; }
  constexpr const T& front() const { return items_.front(); }

 private:
  std::array<T, n> items_{};
  std::size_t size_;
};

/// A symmetry of the print in lattice coordinates x = u w1 + v w2: (u,v) -> M (u,v) + a.
struct LatticeElement {
  std::array<int, 4> m{1, 0, 0, 1};  ///< row-major integer matrix
  std::array<double, 2> a{0, 0};     ///< in [0, 1)
  int det() const { return m[0] * m[3] - m[1] * m[2]; }
};

/// A family of parallel mirror lines in lattice coordinates: direction d; lines h . (u,v) =
/// constant mod 1, with h = (-d2, d1).
struct MirrorFamily {
  std::array<int, 2> direction{};
  Few<double, 2> constants{};
};
using MirrorFamilies = Few<MirrorFamily, 6>;

/// One of the 17 groups, as data.
struct GroupData {
  std::string_view name;
  LatticeType lattice;
  int order;  ///< order of the point group: number of cosets of the translations
  Few<LatticeElement, 2> generators;
  MirrorFamilies mirrors;
  MirrorFamilies glides;  ///< axes of glide reflections that are not also mirrors
};
std::span<const GroupData> wallpaperGroups();
const GroupData* findGroup(std::string_view name);

/// One element per coset of the translations, identity first: the closure of the generators.
std::vector<LatticeElement> cosets(const GroupData& group);

/// A symmetry of the print in centimetres, x -> A x + a.
struct Element {
  Mat2 A = Mat2::Identity();
  Vec2 a = Vec2::Zero();
  bool mirrored = false;  ///< det A < 0
  double angle = 0;  ///< A = R(angle), or A = R(angle) diag(1,-1) (axis at angle / 2) if mirrored
  Vec2 operator()(const Vec2& p) const { return A * p + a; }
  bool operator==(const Element&) const = default;
};

/// A wallpaper group on a given lattice: closure, distances modulo the group, mirror lines. [cm]
class WallpaperGroup {
 public:
  /// Creates a group. A lattice within 1e-6 (relative) of its type is accepted and corrected: use
  /// w1() and w2() afterwards. Errors: kGroupUnknown, kLattice (one sentence with the requirement
  /// of the group).
  static Outcome<WallpaperGroup> make(std::string_view name, const Vec2& w1, const Vec2& w2);

  bool operator==(const WallpaperGroup&) const = default;

  /// The symmetries that may join the print across a seam.
  /// @param continuous_only   excludes mirrors and glides: p1, p2, p3, p4 or p6 on the same lattice
  WallpaperGroup joining(bool continuous_only) const;

  const GroupData& data() const { return *data_; }
  const Vec2& w1() const { return w_[0]; }
  const Vec2& w2() const { return w_[1]; }
  /// One element per coset of the translations; elements()[0] is the identity.
  const std::vector<Element>& elements() const { return elements_; }
  /// A Lagrange-reduced basis of the lattice, shorter vector first, at 60 to 90 degrees, left- or
  /// right-handed.
  const std::array<Vec2, 2>& reducedBasis() const { return reduced_; }

  /// The shortest vector of v + lattice.
  Vec2 reduce(const Vec2& v) const;
  /// Print mismatch: min over elements and lattice vectors of |x - (A y + a) - T|.
  double distance(const Vec2& x, const Vec2& y) const;

  /// True if a piece can be symmetric in itself, which needs a true mirror.
  bool carriesSingle() const { return !data_->mirrors.empty(); }
  /// True if two pieces can be symmetric to each other, which needs a mirror or a glide.
  bool carriesPair() const { return carriesSingle() || !data_->glides.empty(); }

  /// Passes all fields to `each`, for exact copies: a group recreated from w1() and w2() may differ
  /// in the last digit.
  template <class Each>
  void fields(Each&& each) {
    each(data_, w_, reduced_, to_reduced_, gram11_, gram12_, gram22_, elements_, reduced_elements_);
  }

 private:
  /// An element in the coordinates of the reduced basis; the entries of m are whole numbers.
  struct ReducedElement {
    double m00, m01, m10, m11, a0, a1;
    bool operator==(const ReducedElement&) const = default;
    template <class Each>
    void fields(Each&& each) {
      each(m00, m01, m10, m11, a0, a1);
    }
  };
  WallpaperGroup() = default;

  const GroupData* data_ = nullptr;
  std::array<Vec2, 2> w_, reduced_;
  Mat2 to_reduced_;                              ///< cm -> coordinates in the reduced basis
  double gram11_ = 1, gram12_ = 0, gram22_ = 1;  ///< 0 <= 2 gram12 <= gram11 <= gram22
  std::vector<Element> elements_;
  std::vector<ReducedElement> reduced_elements_;
};

/// Names of the groups that carry a piece symmetric in itself, or a mirrored pair: "pm, cm, ...".
std::string groupsForSingle();
std::string groupsForPair();

namespace internal {
#ifdef __FAST_MATH__
#error "roundNear needs IEEE addition: build without -ffast-math"
#endif
/// The nearest whole number, for |x| < 2^51. Adding 1.5 * 2^52 drops the fraction. This needs no
/// library call on targets without a rounding instruction.
inline double roundNear(double x) { return (x + 6755399441055744.0) - 6755399441055744.0; }
/// The same for a vector; in single precision for |x| < 2^22.
inline Lanes<double>::Vector roundNear(const Lanes<double>::Vector& x) {
  return (x + 6755399441055744.0) - 6755399441055744.0;
}
inline Lanes<float>::Vector roundNear(const Lanes<float>::Vector& x) {
  return (x + 12582912.0f) - 12582912.0f;
}
}  // namespace internal

// Rounding in a reduced basis r1, r2 (at 60 to 90 degrees) moves a point to |x|, |y| <= 1/2. Its
// nearest lattice point is then 0, +-r1 or +-r2: the bisectors of +-(r1 - r2) and of all other
// lattice vectors pass outside the part of that cell which is nearest to 0 among these five. So two
// comparisons, 2 |v . r_k| > |r_k|^2, are exact and replace a search of 3 x 3 neighbours.

inline Vec2 WallpaperGroup::reduce(const Vec2& v) const {
  const Vec2 c = to_reduced_ * v;
  const double i = internal::roundNear(c.x()), j = internal::roundNear(c.y());
  const double x = c.x() - i, y = c.y() - j;
  Vec2 shortest = v - i * reduced_[0] - j * reduced_[1];
  const double g1 = x * gram11_ + y * gram12_, g2 = x * gram12_ + y * gram22_;
  const double gain1 = 2 * std::abs(g1) - gram11_, gain2 = 2 * std::abs(g2) - gram22_;
  if (gain1 <= 0 && gain2 <= 0) return shortest;
  if (gain1 >= gain2) return shortest - std::copysign(1.0, g1) * reduced_[0];
  return shortest - std::copysign(1.0, g2) * reduced_[1];
}

inline double WallpaperGroup::distance(const Vec2& x, const Vec2& y) const {
  const Vec2 p = to_reduced_ * x, q = to_reduced_ * y;
  double best = std::numeric_limits<double>::infinity();
  for (const ReducedElement& e : reduced_elements_) {
    double u = p.x() - (e.m00 * q.x() + e.m01 * q.y() + e.a0);
    double v = p.y() - (e.m10 * q.x() + e.m11 * q.y() + e.a1);
    u -= internal::roundNear(u);
    v -= internal::roundNear(v);
    const double g1 = u * gram11_ + v * gram12_, g2 = u * gram12_ + v * gram22_;
    const double nearer =
        std::min(0.0, std::min(gram11_ - 2 * std::abs(g1), gram22_ - 2 * std::abs(g2)));
    best = std::min(best, u * g1 + v * g2 + nearer);
  }
  return std::sqrt(std::max(0.0, best));
}

}  // namespace seamwise
