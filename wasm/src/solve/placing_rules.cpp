#include "solve/placing_rules.h"

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

std::vector<PieceRule> pieceRules(const Problem& problem) {
  const SolveOptions& options = problem.options;
  std::vector<PieceRule> rules(problem.garment.panels.size());
  for (std::size_t p = 0; p < rules.size(); ++p) {
    const Panel& panel = problem.garment.panels[p];
    const int index = static_cast<int>(p);
    GrainRule grain = options.grain;
    if (panel.grain_lock) grain = {*panel.grain_lock, panel.grain_tolerance};
    if (const auto own = options.piece_grain.find(index); own != options.piece_grain.end())
      grain = own->second;
    // the grain line runs along +y of the print, the warp
    const double straight = panel.grain_angle - kPi / 2;
    std::vector<double> angles;
    if (grain.lock == GrainLock::kOn) angles = {straight};
    if (grain.lock == GrainLock::kBias) angles = {straight - kPi / 4, straight + kPi / 4};
    const std::size_t upright = angles.size();
    if (!problem.print.one_way)
      for (std::size_t k = 0; k < upright; ++k) angles.push_back(angles[k] + kPi);
    rules[p].angles = std::move(angles);
    rules[p].tolerance = grain.tolerance;
    if (const auto pin = options.pins.find(index); pin != options.pins.end())
      rules[p].pin = pin->second;
  }
  return rules;
}

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

std::optional<std::size_t> symmetryAgainstGrain(const Problem& problem) {
  const std::vector<PieceRule> rules = pieceRules(problem);
  for (std::size_t k = 0; k < problem.imposed.size(); ++k) {
    const BodySymmetry& s = problem.imposed[k];
    if (!keepsGrain(problem.print.group, s.map, rules[s.pieces[0]], rules[s.pieces[1]], s.single()))
      return k;
  }
  return {};
}

}  // namespace seamwise
