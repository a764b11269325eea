#include "problem/placing_rules.h"

#include <algorithm>
#include <utility>

#include "base/decimal.h"
#include "base/in_quotes.h"

namespace seamwise {
namespace {

constexpr double kObeyed = 1e-6;  ///< cm, the required accuracy of a result
/// Greatest angle between a one-way print and upright on a piece of free grain. [rad]
constexpr double kMostOffUpright = kPi / 3;
constexpr std::size_t kMostAssumed = 4;

/// True if some mirrored element of the print carries the print of `first` to that of `second`
/// under the map.
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

GrainRule grainRule(const Problem& problem, int piece) {
  const SolveOptions& options = problem.options;
  const auto own = options.piece_grain.find(piece);
  if (own != options.piece_grain.end() && own->second.rule) return *own->second.rule;
  const Panel& panel = problem.garment.panels[piece];
  if (panel.grain_lock) return {*panel.grain_lock, panel.grain_tolerance};
  return options.grain;
}

double grainLine(const Problem& problem, int piece) {
  const auto& pieces = problem.options.piece_grain;
  const auto own = pieces.find(piece);
  if (own != pieces.end() && own->second.line) return *own->second.line;
  return problem.garment.panels[piece].grain_angle;
}

std::vector<PieceRule> pieceRules(const Problem& problem) {
  const bool one_way = problem.print.one_way;
  std::vector<PieceRule> rules(problem.garment.panels.size());
  for (std::size_t p = 0; p < rules.size(); ++p) {
    const int index = static_cast<int>(p);
    const GrainRule grain = grainRule(problem, index);
    const auto pin = problem.options.pins.find(index);
    const bool pinned = pin != problem.options.pins.end();
    // The grain line runs along the warp, +y of the print.
    const double straight = grainLine(problem, index) - kPi / 2;
    std::vector<double>& angles = rules[p].angles;
    rules[p].tolerance = grain.tolerance;
    switch (grain.lock) {
      case GrainLock::kFree:
        if (!one_way || pinned) break;  // a pin may have any angle
        angles = {straight};
        rules[p].tolerance = kMostOffUpright;
        break;
      case GrainLock::kOn:
        angles = {straight};
        if (!one_way) angles.push_back(straight + kPi);
        break;
      case GrainLock::kAcross:  // neither way is more upright than the other
        angles = {straight - kPi / 2, straight + kPi / 2};
        break;
      case GrainLock::kBias:
        angles = {straight - kPi / 4, straight + kPi / 4};
        if (!one_way) angles.insert(angles.end(), {straight + 3 * kPi / 4, straight + 5 * kPi / 4});
        break;
    }
    if (pinned) rules[p].pin = pin->second;
  }
  return rules;
}

std::optional<Note> assumedGrain(const Problem& problem, const std::string& file) {
  const SolveOptions& options = problem.options;
  std::string names;
  std::vector<int> assumed;
  for (std::size_t p = 0; p < problem.garment.panels.size(); ++p) {
    const Panel& panel = problem.garment.panels[p];
    const int index = static_cast<int>(p);
    const auto own = options.piece_grain.find(index);
    const bool said = panel.grain_stated || options.pins.count(index) > 0 ||
                      (own != options.piece_grain.end() && own->second.line);
    const bool printed =
        std::find(options.plain.begin(), options.plain.end(), index) == options.plain.end();
    const bool asked = grainRule(problem, index).lock != GrainLock::kFree || problem.print.one_way;
    if (said || !printed || !asked) continue;
    if (assumed.size() < kMostAssumed)
      names += (assumed.empty() ? "" : ", ") + inQuotes(panel.name);
    assumed.push_back(index);
  }
  if (assumed.empty()) return {};
  if (assumed.size() > kMostAssumed)
    names += " and " + decimal(assumed.size() - kMostAssumed) + " more";
  return Note{
      "grainAssumed",
      file + " has no grain line for these pieces, so theirs is assumed to run upwards as drawn: " +
          names + "; give 'angleDeg' in grain.pieces of the options to say otherwise.",
      std::move(assumed)};
}

std::optional<std::size_t> symmetryAgainstPins(const Problem& problem,
                                               const std::vector<BodySymmetry>& imposed) {
  const auto& pins = problem.options.pins;
  for (std::size_t k = 0; k < imposed.size(); ++k) {
    const BodySymmetry& s = imposed[k];
    const auto first = pins.find(s.pieces[0]), second = pins.find(s.pieces[1]);
    if (first == pins.end() || second == pins.end()) continue;
    if (!mirrors(problem.print.group, first->second, second->second, s.map)) return k;
  }
  return {};
}

std::optional<std::size_t> symmetryAgainstGrain(const Problem& problem,
                                                const std::vector<BodySymmetry>& imposed) {
  const std::vector<PieceRule> rules = pieceRules(problem);
  for (std::size_t k = 0; k < imposed.size(); ++k) {
    const BodySymmetry& s = imposed[k];
    if (!keepsGrain(problem.print.group, s.map, rules[s.pieces[0]], rules[s.pieces[1]], s.single()))
      return k;
  }
  return {};
}

}  // namespace seamwise
