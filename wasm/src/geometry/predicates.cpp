#include "geometry/predicates.h"

#include <cmath>

#include "base/product.h"

namespace seamwise {
namespace {

constexpr double kRounding = 1.1102230246251565e-16;  // half a unit in the last place of 1

/// An exact sum of doubles, smallest part first [Shewchuk 1997, grow-expansion].
class ExactSum {
 public:
  void add(double value) {
    for (int i = 0; i < size_; ++i) {
      const double sum = value + part_[i];
      const double virtual_part = sum - value;
      part_[i] = (value - (sum - virtual_part)) + (part_[i] - virtual_part);
      value = sum;
    }
    part_[size_++] = value;
  }
  void addProduct(double x, double y) {
    const double product = x * y;
    add(lostOf(x, y, product));
    add(product);
  }
  int sign() const {
    for (int i = size_; i-- > 0;)
      if (part_[i] != 0) return part_[i] > 0 ? 1 : -1;
    return 0;
  }

 private:
  double part_[12];  // six products of two doubles
  int size_ = 0;
};

}  // namespace

int orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double left = (a.x() - c.x()) * (b.y() - c.y());
  const double right = (a.y() - c.y()) * (b.x() - c.x());
  const double det = left - right;
  const double bound = (3 + 16 * kRounding) * kRounding * (std::abs(left) + std::abs(right));
  if (det > bound) return 1;
  if (det < -bound) return -1;
  // ax by - ay bx + bx cy - by cx + cx ay - cy ax, every product split into two doubles
  ExactSum sum;
  sum.addProduct(a.x(), b.y());
  sum.addProduct(-a.y(), b.x());
  sum.addProduct(b.x(), c.y());
  sum.addProduct(-b.y(), c.x());
  sum.addProduct(c.x(), a.y());
  sum.addProduct(-c.y(), a.x());
  return sum.sign();
}

bool insideCircle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const Vec2 p = a - d, q = b - d, r = c - d;
  const double pq = p.x() * q.y(), qp = p.y() * q.x();
  const double qr = q.x() * r.y(), rq = q.y() * r.x();
  const double rp = r.x() * p.y(), pr = r.y() * p.x();
  const double pp = p.squaredNorm(), qq = q.squaredNorm(), rr = r.squaredNorm();
  const double det = pp * (qr - rq) + qq * (rp - pr) + rr * (pq - qp);
  const double size = pp * (std::abs(qr) + std::abs(rq)) + qq * (std::abs(rp) + std::abs(pr)) +
                      rr * (std::abs(pq) + std::abs(qp));
  return det > (10 + 96 * kRounding) * kRounding * size;
}

}  // namespace seamwise
