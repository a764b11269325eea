#include "wallpaper/lattice.h"

#include "base/decimal.h"

namespace seamwise {
namespace {

constexpr double kTypeTolerance = 1e-6;  // relative
const double kSin60 = std::sqrt(3.0) / 2;

std::string number(double x, int digits = 6) {
  return significant(x + 0.0, digits);  // + 0.0 prevents "-0"
}

/// A vector with all digits, because users copy it from the message.
std::string vector(const Vec2& v) {
  const auto exact = [](double x) { return number(std::abs(x) < 1e-12 ? 0 : x, 15); };
  return "(" + exact(v.x()) + ", " + exact(v.y()) + ")";
}

Error latticeError(std::string message) { return {Failure::kLattice, std::move(message), -1, -1}; }

/// An addition to a remedy for a group with two conventions that the lattice does not distinguish.
std::string convention(const GroupData& group) {
  if (group.name != "pmg") return "";
  return " (the mirrors of pmg run along w1 here, its glides along w2; in the International Tables "
         "it "
         "is the other way round)";
}

Error notOfType(const GroupData& group, const std::string& needs, const std::string& given,
                const std::string& remedy) {
  return latticeError("print group " + std::string(group.name) + " needs " + needs + ", but " +
                      given + ": " + remedy + convention(group));
}

Vec2 turned60(const Vec2& v) { return 0.5 * v + kSin60 * perp(v); }

std::string degrees(const Vec2& w1, const Vec2& w2) {
  const double angle = turnBetween(w1, w2);
  return "w1 and w2 are at " + number(angle * 180 / kPi, 8) + " degrees";
}

std::string lengths(const Vec2& w1, const Vec2& w2) {
  return "w1 is " + number(w1.norm(), 8) + " cm and w2 is " + number(w2.norm(), 8) + " cm long";
}

/// Returns `given` if it differs from `exact` only by rounding, so that a file keeps its digits;
/// otherwise `exact`.
Vec2 keepDigits(const Vec2& given, const Vec2& exact) {
  return (given - exact).norm() <= 1e-15 * exact.norm() ? given : exact;
}

Outcome<std::array<Vec2, 2>> rightAngled(const GroupData& group, const Vec2& w1, const Vec2& w2) {
  const double l1 = w1.norm(), l2 = w2.norm();
  const bool square = group.lattice == LatticeType::kSquare;
  if (std::abs(w1.dot(w2)) > kTypeTolerance * l1 * l2) {
    return notOfType(group, square ? "a square lattice" : "w1 perpendicular to w2", degrees(w1, w2),
                     "take w2 = " + vector(perp(w1) * (square ? 1 : l2 / l1)) +
                         " or choose p1 or p2, which take any lattice");
  }
  if (!square) return std::array<Vec2, 2>{w1, keepDigits(w2, perp(w1) * (l2 / l1))};
  if (std::abs(l1 - l2) > kTypeTolerance * std::max(l1, l2)) {
    return notOfType(group, "a square lattice", lengths(w1, w2),
                     "take w2 = " + vector(perp(w1)) +
                         " or choose a group of the rectangular lattice (pm, pg, pmm, pmg, pgg)");
  }
  return std::array<Vec2, 2>{w1, keepDigits(w2, perp(w1))};
}

Outcome<std::array<Vec2, 2>> rhombic(const GroupData& group, const Vec2& w1, const Vec2& w2) {
  const double l1 = w1.norm(), l2 = w2.norm();
  if (std::abs(l1 - l2) > kTypeTolerance * std::max(l1, l2)) {
    std::string remedy = "scale one of them or choose p1 or p2, which take any lattice";
    if (std::abs(w1.dot(w2)) <= kTypeTolerance * l1 * l2) {
      remedy =
          "if they are the sides of the centred rectangle, take w1 = " + vector((w1 - w2) / 2) +
          " and w2 = " + vector((w1 + w2) / 2);
    }
    return notOfType(group, "a rhombic lattice, w1 and w2 of one length", lengths(w1, w2), remedy);
  }
  const double length = (l1 + l2) / 2;
  return std::array<Vec2, 2>{keepDigits(w1, w1 * (length / l1)),
                             keepDigits(w2, w2 * (length / l2))};
}

Outcome<std::array<Vec2, 2>> hexagonal(const GroupData& group, const Vec2& w1, const Vec2& w2) {
  const double l1 = w1.norm(), l2 = w2.norm();
  const Vec2 wanted = turned60(w1);
  if ((w2 - wanted).norm() <= kTypeTolerance * l1)
    return std::array<Vec2, 2>{w1, keepDigits(w2, wanted)};
  const std::string needs = "a hexagonal lattice, w1 and w2 of one length at 60 degrees";
  if (((w2 + w1) - wanted).norm() <= kTypeTolerance * l1) {
    return notOfType(group, needs, "w1 and w2 are at 120 degrees",
                     "take w1 + w2 = " + vector(wanted) + " for w2");
  }
  const bool same_length = std::abs(l1 - l2) <= kTypeTolerance * std::max(l1, l2);
  return notOfType(group, needs, same_length ? degrees(w1, w2) : lengths(w1, w2),
                   "take w2 = " + vector(wanted) + " or choose p1 or p2, which take any lattice");
}

/// The remedy that makes a left-handed lattice right-handed without moving the mirrors. If w1 and
/// w2 have different roles (rectangular), w2 is reversed. If w1 + w2 is an axis, they are swapped.
std::string rightHandedRemedy(const GroupData& group, const Vec2& w1, const Vec2& w2) {
  if (group.lattice == LatticeType::kRectangular) return "take w2 = " + vector(-w2);
  return "swap them: w1 = " + vector(w2) + ", w2 = " + vector(w1);
}

}  // namespace

std::array<Vec2, 2> lagrangeReduced(const Vec2& w1, const Vec2& w2) {
  Vec2 a = w1, b = w2;
  if (a.squaredNorm() > b.squaredNorm()) std::swap(a, b);
  // Each step shortens b or ends. The margin exists because rounding could make the last two steps
  // alternate.
  while (a.squaredNorm() > 0) {
    b -= std::round(a.dot(b) / a.squaredNorm()) * a;
    if (b.squaredNorm() >= a.squaredNorm() * (1 - 1e-12)) break;
    std::swap(a, b);
  }
  if (a.squaredNorm() > b.squaredNorm()) std::swap(a, b);
  if (a.dot(b) < 0) b = -b;
  return {a, b};
}

Outcome<std::array<Vec2, 2>> checkedLattice(const GroupData& group, const Vec2& w1,
                                            const Vec2& w2) {
  for (const auto& [name, w] : {std::pair{"w1", w1}, std::pair{"w2", w2}}) {
    if (!w.allFinite()) {
      return latticeError(std::string("print lattice: ") + name +
                          " is not finite: give two numbers in cm");
    }
    // The tolerance accepts a vector of exactly the limit's length in any direction.
    const double length = w.norm();
    if (length < kShortestRepeat * (1 - 1e-9) || length > kLongestRepeat * (1 + 1e-9)) {
      return latticeError(std::string("print lattice: ") + name + " is " + number(length) +
                          " cm long, but a repeat must be between " + number(kShortestRepeat) +
                          " and " + number(kLongestRepeat) + " cm: check that it is given in cm");
    }
  }
  const double area = cross(w1, w2);
  if (std::abs(area) <= 1e-9 * w1.norm() * w2.norm()) {
    return latticeError("print lattice: w1 " + vector(w1) + " and w2 " + vector(w2) +
                        " are parallel: give two repeats in different directions (for stripes, a "
                        "short one along the stripe)");
  }
  if (area < 0) {
    return latticeError(
        "print lattice: w1 to w2 turns clockwise, but must turn counter-clockwise: " +
        rightHandedRemedy(group, w1, w2) + convention(group));
  }
  const double shortest = lagrangeReduced(w1, w2)[0].norm();
  if (shortest < kShortestRepeat * (1 - 1e-9)) {
    return latticeError("print lattice: w1 and w2 combine to a repeat of only " + number(shortest) +
                        " cm, but none may be below " + number(kShortestRepeat) +
                        " cm: make them less parallel");
  }
  switch (group.lattice) {
    case LatticeType::kOblique:
      break;
    case LatticeType::kRectangular:
    case LatticeType::kSquare:
      return rightAngled(group, w1, w2);
    case LatticeType::kRhombic:
      return rhombic(group, w1, w2);
    case LatticeType::kHexagonal:
      return hexagonal(group, w1, w2);
  }
  return std::array<Vec2, 2>{w1, w2};
}

}  // namespace seamwise
