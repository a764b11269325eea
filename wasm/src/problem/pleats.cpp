#include "problem/pleats.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "base/decimal.h"
#include "base/in_quotes.h"
#include "problem/placing_rules.h"
#include "tuning/pleats.h"

namespace seamwise {
namespace {

/// A pleat as an interval across the pleats of its panel.
struct Pleat {
  double from = 0, to = 0;
  int parts = 1;  ///< number of equal steps of the print between the lines: 2 for a box pleat
  double width() const { return to - from; }
};

/// Parallel pleats of a panel, in order.
struct PleatedPanel {
  Vec2 across = Vec2::UnitX();
  std::vector<Pleat> pleats;
};

/// An angle of the piece at which a lattice vector runs across its pleats, and their new widths.
struct Choice {
  double angle = 0;
  double off_grain = 0;  ///< rad
  std::vector<PleatFit::Strip> strips;
  double change = 0;  ///< sum of the changes of width
  bool possible = false;
};

/// Returns nothing if the lines of the panel's pleats are not parallel, or pleats overlap.
std::optional<PleatedPanel> pleatedPanel(const Panel& panel) {
  PleatedPanel found;
  for (const Fold& fold : panel.folds) {
    if (!fold.takesUp()) continue;
    const Vec2 across = -perp(fold.line[1] - fold.line[0]).normalized();
    if (found.pleats.empty()) found.across = across;
    double at[2][2];
    for (int k = 0; k < 2; ++k) {
      const Fold::Line& line = k == 0 ? fold.line : fold.to;
      for (int end = 0; end < 2; ++end) at[k][end] = found.across.dot(line[end]);
      if (std::abs(at[k][1] - at[k][0]) > PleatTuning::kParallelCm) return {};
    }
    const double line = (at[0][0] + at[0][1]) / 2, to = (at[1][0] + at[1][1]) / 2;
    found.pleats.push_back(
        {std::min(line, to), std::max(line, to), fold.kind == FoldKind::kBox ? 2 : 1});
  }
  std::sort(found.pleats.begin(), found.pleats.end(),
            [](const Pleat& one, const Pleat& other) { return one.from < other.from; });
  for (std::size_t k = 1; k < found.pleats.size(); ++k)
    if (found.pleats[k].from < found.pleats[k - 1].to - PleatTuning::kParallelCm) return {};
  return found;
}

/// Lattice vectors up to a length that are no multiples of others, one of each opposite pair.
std::vector<Vec2> primitives(const WallpaperGroup& group, double longest) {
  const auto& [r1, r2] = group.reducedBasis();
  const double height = std::abs(cross(r1, r2));
  const int most1 = static_cast<int>(longest * r2.norm() / height);
  const int most2 = static_cast<int>(longest * r1.norm() / height);
  std::vector<Vec2> found;
  for (int i = 0; i <= most1; ++i)
    for (int j = i == 0 ? 1 : -most2; j <= most2; ++j) {
      const Vec2 v = i * r1 + j * r2;
      if (std::gcd(i, j) == 1 && v.norm() <= longest) found.push_back(v);
    }
  return found;
}

/// The admissible angles of a piece whose pleats hang by its grain, and the greatest deviation.
std::pair<std::vector<double>, double> anglesOf(const Problem& problem, int piece) {
  const PieceRule rule = pieceRules(problem)[piece];
  if (rule.pin) return {{rule.pin->angle}, 0.0};
  if (grainRule(problem, piece).lock != GrainLock::kFree) return {rule.angles, rule.tolerance};
  return {{grainLine(problem, piece) - kPi / 2}, PleatTuning::kMostTurn};
}

class PleatChooser {
 public:
  PleatChooser(const Problem& problem, int piece, const PleatedPanel& panel)
      : panel_(panel), most_moved_(problem.options.max_change_cm) {
    std::tie(angles_, tolerance_) = anglesOf(problem, piece);
    const auto& basis = problem.print.group.reducedBasis();
    double longest = 2 * basis[1].norm();
    for (const Pleat& pleat : panel.pleats)
      longest = std::max(longest, (1 + PleatTuning::kMostGrowth) * pleat.width() / pleat.parts);
    for (const Vec2& repeat : primitives(problem.print.group, longest)) consider(repeat);
  }

  const std::optional<Choice>& best() const { return best_; }

 private:
  void consider(const Vec2& repeat) {
    // R(angle)^T across is along the repeat, in either direction.
    const double turned = directionOf(panel_.across) - directionOf(repeat);
    for (const double wanted : angles_) {
      const double off = std::remainder(turned - wanted, kPi);
      if (std::abs(off) > tolerance_ + PleatTuning::kSameAngle) continue;
      Choice choice{wanted + off, std::abs(off), {}, 0, true};
      for (const Pleat& pleat : panel_.pleats) {
        const double unit = pleat.parts * repeat.norm(), width = pleat.width();
        const double growth = std::max(1.0, std::round(width / unit)) * unit - width;
        choice.strips.push_back({pleat.from, pleat.to, growth});
        choice.change += std::abs(growth);
        choice.possible &= std::abs(growth) <= PleatTuning::kMostGrowth * width;
      }
      choice.possible &=
          PleatFit(panel_.across, choice.strips).movement() <= most_moved_ + PleatTuning::kWholeCm;
      if (!best_ || isBetter(choice, *best_)) best_ = std::move(choice);
    }
  }

  static bool isBetter(const Choice& one, const Choice& other) {
    if (one.possible != other.possible) return one.possible;
    const double nearer = one.off_grain - other.off_grain;
    if (std::abs(nearer) > PleatTuning::kSameAngle) return nearer < 0;
    return one.change < other.change - PleatTuning::kWholeCm;
  }

  const PleatedPanel& panel_;
  double most_moved_;
  std::vector<double> angles_;
  double tolerance_ = 0;
  std::optional<Choice> best_;
};

/// True if a sewn edge runs across a pleat.
bool isSewnAcross(const Garment& garment, int piece, const PleatFit& fit) {
  const auto runsAcross = [&](const EdgeRef& edge) {
    if (edge.piece != piece) return false;
    const Curve& curve = garment.panels[piece].edges[edge.edge];
    return !fit.holds(curve) || fit.stripOf(curve) >= 0;
  };
  return std::any_of(garment.stitches.begin(), garment.stitches.end(), [&](const Stitch& stitch) {
    return runsAcross(stitch.a) || runsAcross(stitch.b);
  });
}

bool holdsAll(const Panel& panel, const PleatFit& fit) {
  const auto holds = [&](const Curve& curve) { return fit.holds(curve); };
  return std::all_of(panel.edges.begin(), panel.edges.end(), holds) &&
         std::all_of(panel.holes.begin(), panel.holes.end(), [&](const std::vector<Curve>& hole) {
           return std::all_of(hole.begin(), hole.end(), holds);
         });
}

void apply(const PleatFit& fit, int piece, Problem* problem) {
  Panel& panel = problem->garment.panels[piece];
  for (Curve& edge : panel.edges) edge = fit.fitted(edge);
  for (std::vector<Curve>& hole : panel.holes)
    for (Curve& edge : hole) edge = fit.fitted(edge);
  for (Fold& fold : panel.folds)
    for (Fold::Line* line : {&fold.line, &fold.to})
      for (Vec2& p : *line) p = fit.fitted(p);
  for (MatchLine& match : problem->options.matches) {
    if (match.piece_a == piece)
      for (Vec2& p : match.a) p = fit.fitted(p);
    if (match.piece_b == piece)
      for (Vec2& p : match.b) p = fit.fitted(p);
  }
  problem->pleat_fits.emplace(piece, fit);
}

/// Fixes the angle of the piece and its outline.
void fix(const Choice& choice, int piece, Problem* problem) {
  SolveOptions& options = problem->options;
  if (options.pins.count(piece) == 0)
    options.piece_grain[piece] = {GrainRule{GrainLock::kOn, 0}, choice.angle + kPi / 2};
  const auto edges = static_cast<int>(problem->garment.panels[piece].edges.size());
  for (int edge = 0; edge < edges; ++edge) options.locked.push_back({piece, edge});
}

/// Pieces about whose pleats the same is to be said.
struct Finding {
  const char* code;
  std::vector<double> numbers;  ///< cm
  std::vector<int> pieces;
};

std::string sentence(const Finding& finding, const std::string& names) {
  const std::string_view code = finding.code;
  const auto cm = [&](std::size_t k) { return significant(finding.numbers[k], 4) + " cm"; };
  if (code == "pleatsFitted")
    return "The print runs on across the pleats of " + names + ": they take up " + cm(1) +
           " in place of " + cm(0) + ", a whole repeat.";
  if (code == "pleatsOff")
    return "The print does not run on across the pleats of " + names + ": they take up " + cm(0) +
           ", and a whole repeat is " + cm(1) +
           ", which is out of reach; draft them so, or choose another size of the print.";
  if (code == "pleatsUndivided")
    return "The pleats of " + names + " stay " + cm(0) + " wide in place of a whole repeat of " +
           cm(1) +
           ", because edges run across them; divide the edges where the lines of the "
           "pleats meet them.";
  if (code == "pleatsSewnFlat")
    return "Edges of " + names +
           " are sewn across their pleats as if these were open; divide the "
           "edges where the lines of the pleats meet them.";
  if (code == "pleatsOffGrain")
    return "The print does not run on across the pleats of " + names +
           ": no repeat of it runs across them on this grain; turn the print, or free the grain.";
  return "The print is not matched across the pleats of " + names +
         ", because their lines are not parallel or they overlap.";
}

class PleatFitting {
 public:
  explicit PleatFitting(Problem* problem) : problem_(problem) {}

  void fitPiece(int piece) {
    const std::optional<PleatedPanel> pleated = pleatedPanel(problem_->garment.panels[piece]);
    if (!pleated) return find("pleatsUneven", piece);
    const PleatChooser chooser(*problem_, piece, *pleated);
    if (!chooser.best()) return find("pleatsOffGrain", piece);
    const Choice& choice = *chooser.best();
    const PleatFit fit(pleated->across, choice.strips);
    const bool is_sewn_across = isSewnAcross(problem_->garment, piece, fit);
    if (is_sewn_across) find("pleatsSewnFlat", piece);
    if (choice.change > PleatTuning::kWholeCm) {
      const PleatFit::Strip& first = fit.strips().front();
      const double drafted = first.to - first.from, whole = drafted + first.growth;
      if (!choice.possible) return find("pleatsOff", piece, {drafted, whole});
      if (is_sewn_across || !holdsAll(problem_->garment.panels[piece], fit))
        return find("pleatsUndivided", piece, {drafted, whole});
      find("pleatsFitted", piece, {drafted, whole});
      apply(fit, piece, problem_);
    }
    fix(choice, piece, problem_);
  }

  void addNotes() {
    for (Finding& finding : findings_) {
      std::string names;
      for (const int piece : finding.pieces)
        names += (names.empty() ? "" : ", ") + inQuotes(problem_->garment.panels[piece].name);
      problem_->notes.push_back({finding.code,
                                 sentence(finding, names),
                                 std::move(finding.pieces),
                                 {},
                                 std::move(finding.numbers)});
    }
  }

 private:
  void find(const char* code, int piece, std::vector<double> numbers = {}) {
    for (Finding& finding : findings_)
      if (std::string_view(finding.code) == code && finding.numbers == numbers) {
        finding.pieces.push_back(piece);
        return;
      }
    findings_.push_back({code, std::move(numbers), {piece}});
  }

  Problem* problem_;
  std::vector<Finding> findings_;
};

}  // namespace

void fitPleats(Problem* problem) {
  if (problem->options.method != Method::kBest) return;
  const std::vector<int>& plain = problem->options.plain;
  PleatFitting fitting(problem);
  for (std::size_t p = 0; p < problem->garment.panels.size(); ++p) {
    const int piece = static_cast<int>(p);
    const std::vector<Fold>& folds = problem->garment.panels[p].folds;
    if (std::any_of(folds.begin(), folds.end(), [](const Fold& fold) { return fold.takesUp(); }) &&
        std::find(plain.begin(), plain.end(), piece) == plain.end())
      fitting.fitPiece(piece);
  }
  fitting.addNotes();
}

}  // namespace seamwise
