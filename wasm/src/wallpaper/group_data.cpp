// The 17 wallpaper groups as data, in lattice coordinates, each at its standard origin. The
// directions of the mirror families are those of Wolff et al. 2019, Fig. 4.
#include "wallpaper/group.h"

namespace seamwise {
namespace {

constexpr double kHalf = 0.5;
constexpr std::array<int, 4> kHalfTurn{-1, 0, 0, -1};
constexpr std::array<int, 4> kMirrorW1{1, 0, 0, -1};     // rectangular: the axis is w1
constexpr std::array<int, 4> kSwap{0, 1, 1, 0};          // rhombic, hexagonal: the axis is w1 + w2
constexpr std::array<int, 4> kQuarterTurn{0, -1, 1, 0};  // square
constexpr std::array<int, 4> kThirdTurn{-1, -1, 1, 0};   // hexagonal
constexpr std::array<int, 4> kSixthTurn{0, -1, 1, 1};    // hexagonal
constexpr std::array<int, 4> kMirrorHex{1, 1, 0, -1};    // hexagonal: the axis is w1

constexpr std::array<int, 2> kW1{1, 0}, kW2{0, 1}, kSum{1, 1}, kDifference{1, -1};
constexpr std::array<int, 2> k90{1, -2}, k150{2, -1};  // hexagonal: degrees from w1

using enum LatticeType;
using Constants = Few<double, 2>;
constexpr Constants kWhole{0}, kOneHalf{kHalf}, kHalves{0, kHalf}, kQuarters{0.25, 0.75};
constexpr std::array<GroupData, 17> kGroups{{
    {"p1", kOblique, 1, {}, {}, {}},
    {"p2", kOblique, 2, {{kHalfTurn, {0, 0}}}, {}, {}},
    {"pm", kRectangular, 2, {{kMirrorW1, {0, 0}}}, {{kW1, kHalves}}, {}},
    {"pg", kRectangular, 2, {{kMirrorW1, {kHalf, 0}}}, {}, {{kW1, kHalves}}},
    {"cm", kRhombic, 2, {{kSwap, {0, 0}}}, {{kSum, kWhole}}, {{kSum, kOneHalf}}},
    {"pmm",
     kRectangular,
     4,
     {{kHalfTurn, {0, 0}}, {kMirrorW1, {0, 0}}},
     {{kW1, kHalves}, {kW2, kHalves}},
     {}},
    {"pmg",
     kRectangular,
     4,
     {{kHalfTurn, {0, 0}}, {kMirrorW1, {0, kHalf}}},
     {{kW1, kQuarters}},
     {{kW2, kHalves}}},
    {"pgg",
     kRectangular,
     4,
     {{kHalfTurn, {0, 0}}, {kMirrorW1, {kHalf, kHalf}}},
     {},
     {{kW1, kQuarters}, {kW2, kQuarters}}},
    {"cmm",
     kRhombic,
     4,
     {{kHalfTurn, {0, 0}}, {kSwap, {0, 0}}},
     {{kSum, kWhole}, {kDifference, kWhole}},
     {{kSum, kOneHalf}, {kDifference, kOneHalf}}},
    {"p4", kSquare, 4, {{kQuarterTurn, {0, 0}}}, {}, {}},
    {"p4m",
     kSquare,
     8,
     {{kQuarterTurn, {0, 0}}, {kMirrorW1, {0, 0}}},
     {{kW1, kHalves}, {kW2, kHalves}, {kSum, kWhole}, {kDifference, kWhole}},
     {{kSum, kOneHalf}, {kDifference, kOneHalf}}},
    {"p4g",
     kSquare,
     8,
     {{kQuarterTurn, {0, 0}}, {kMirrorW1, {kHalf, kHalf}}},
     {{kSum, kOneHalf}, {kDifference, kOneHalf}},
     {{kW1, kQuarters}, {kW2, kQuarters}, {kSum, kWhole}, {kDifference, kWhole}}},
    {"p3", kHexagonal, 3, {{kThirdTurn, {0, 0}}}, {}, {}},
    {"p3m1",
     kHexagonal,
     6,
     {{kThirdTurn, {0, 0}}, {kSwap, {0, 0}}},
     {{kSum, kWhole}, {k90, kWhole}, {k150, kWhole}},
     {{kSum, kOneHalf}, {k90, kOneHalf}, {k150, kOneHalf}}},
    {"p31m",
     kHexagonal,
     6,
     {{kThirdTurn, {0, 0}}, {kMirrorHex, {0, 0}}},
     {{kW1, kWhole}, {kW2, kWhole}, {kDifference, kWhole}},
     {{kW1, kOneHalf}, {kW2, kOneHalf}, {kDifference, kOneHalf}}},
    {"p6", kHexagonal, 6, {{kSixthTurn, {0, 0}}}, {}, {}},
    {"p6m",
     kHexagonal,
     12,
     {{kSixthTurn, {0, 0}}, {kMirrorHex, {0, 0}}},
     {{kW1, kWhole},
      {kW2, kWhole},
      {kDifference, kWhole},
      {kSum, kWhole},
      {k90, kWhole},
      {k150, kWhole}},
     {{kW1, kOneHalf},
      {kW2, kOneHalf},
      {kDifference, kOneHalf},
      {kSum, kOneHalf},
      {k90, kOneHalf},
      {k150, kOneHalf}}},
}};

std::string joinNames(bool (*wanted)(const GroupData&)) {
  std::string names;
  for (const GroupData& group : wallpaperGroups()) {
    if (!wanted(group)) continue;
    if (!names.empty()) names += ", ";
    names += group.name;
  }
  return names;
}

}  // namespace

std::span<const GroupData> wallpaperGroups() { return kGroups; }

const GroupData* findGroup(std::string_view name) {
  for (const GroupData& group : wallpaperGroups()) {
    if (group.name == name) return &group;
  }
  return nullptr;
}

std::string groupsForSingle() {
  return joinNames([](const GroupData& group) { return !group.mirrors.empty(); });
}

std::string groupsForPair() {
  return joinNames(
      [](const GroupData& group) { return !group.mirrors.empty() || !group.glides.empty(); });
}

std::vector<LatticeElement> cosets(const GroupData& group) {
  const auto fraction = [](double x) { return x - std::floor(x); };
  std::vector<LatticeElement> all{LatticeElement{}};
  // Try every product with a generator until none is new; orders are at most 12.
  for (std::size_t k = 0; k < all.size(); ++k) {
    for (const LatticeElement& g : group.generators) {
      const LatticeElement e = all[k];
      const LatticeElement product{
          {g.m[0] * e.m[0] + g.m[1] * e.m[2], g.m[0] * e.m[1] + g.m[1] * e.m[3],
           g.m[2] * e.m[0] + g.m[3] * e.m[2], g.m[2] * e.m[1] + g.m[3] * e.m[3]},
          {fraction(g.m[0] * e.a[0] + g.m[1] * e.a[1] + g.a[0]),
           fraction(g.m[2] * e.a[0] + g.m[3] * e.a[1] + g.a[1])}};
      const bool known = std::any_of(all.begin(), all.end(), [&](const LatticeElement& other) {
        return other.m == product.m;
      });
      if (!known) all.push_back(product);
    }
  }
  return all;
}

}  // namespace seamwise
