#include "solve/pins.h"

#include <algorithm>

namespace seamwise {
namespace {

constexpr double kObeyed = 1e-6;  ///< cm: as exact as a result has to be

/// Whether some mirrored element of the print carries `first`'s print to `second`'s, over the map.
bool mirrors(const WallpaperGroup& group, const Alignment& first, const Alignment& second,
             const RigidMotion& map) {
  const Vec2 probes[3] = {Vec2(0, 0), Vec2(10, 0), Vec2(0, 10)};
  return std::any_of(group.elements().begin(), group.elements().end(), [&](const Element& e) {
    return e.mirrored && std::all_of(std::begin(probes), std::end(probes), [&](const Vec2& p) {
             return group.reduce(second.toPrint(map(p)) - e(first.toPrint(p))).norm() < kObeyed;
           });
  });
}

}  // namespace

std::optional<std::size_t> symmetryAgainstPins(const Problem& problem) {
  const auto& pins = problem.options.pins;
  for (std::size_t k = 0; k < problem.imposed.size(); ++k) {
    const BodySymmetry& s = problem.imposed[k];
    const auto first = pins.find(s.pieces[0]), second = pins.find(s.pieces[1]);
    if (first == pins.end() || second == pins.end()) continue;
    if (!mirrors(problem.print.group, first->second, second->second, s.map)) return k;
  }
  return {};
}

}  // namespace seamwise
