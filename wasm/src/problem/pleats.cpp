#include "problem/pleats.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "base/decimal.h"
#include "base/in_quotes.h"
#include "base/sort_by.h"
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
  PleatFit fit;
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
  sortBy(found.pleats, [](const Pleat& pleat) { return pleat.from; });
  for (std::size_t k = 1; k < found.pleats.size(); ++k)
    if (found.pleats[k].from < found.pleats[k - 1].to - PleatTuning::kParallelCm) return {};
  return found;
}

/// The admissible angles of a piece whose pleats hang by its grain, and the greatest deviation.
PieceRule anglesOf(const Problem& problem, int piece) {
  PieceRule rule = pieceRules(problem)[piece];
  if (rule.pin) {
    rule.angles = {rule.pin->angle};
    rule.tolerance = 0;
  } else if (grainRule(problem, piece).lock == GrainLock::kFree) {
    rule.angles = {grainLine(problem, piece) - kPi / 2};
    rule.tolerance = PleatTuning::kMostTurn;
  }
  return rule;
}

class PleatChooser {
 public:
  PleatChooser(const Problem& problem, int piece, const PleatedPanel& panel)
      : piece_(piece), panel_(panel), most_moved_(problem.options.max_change_cm) {
    const PieceRule rule = anglesOf(problem, piece);
    const auto& [r1, r2] = problem.print.group.reducedBasis();
    double longest = 2 * r2.norm();
    for (const Pleat& pleat : panel.pleats)
      longest = std::max(longest, (1 + PleatTuning::kMostGrowth) * pleat.width() / pleat.parts);
    // Lattice vectors that are no multiples of others, one of each opposite pair.
    const double height = std::abs(cross(r1, r2));
    const int most1 = static_cast<int>(longest * r2.norm() / height);
    const int most2 = static_cast<int>(longest * r1.norm() / height);
    for (int i = 0; i <= most1; ++i)
      for (int j = i == 0 ? 1 : -most2; j <= most2; ++j)
        if (std::gcd(i, j) == 1) consider(i * r1 + j * r2, rule);
  }

  const std::optional<Choice>& best() const { return best_; }

 private:
  void consider(const Vec2& repeat, const PieceRule& rule) {
    // R(angle)^T across is along the repeat, in either direction.
    const double turned = directionOf(panel_.across) - directionOf(repeat);
    for (const double wanted : rule.angles) {
      const double half_turns = std::nearbyint((turned - wanted) / kPi);
      const double off = turned - wanted - half_turns * kPi;
      if (std::abs(off) > rule.tolerance + PleatTuning::kSameAngle) continue;
      Choice choice{wanted + off, std::abs(off), {piece_, panel_.across, {}}, 0, true};
      for (const Pleat& pleat : panel_.pleats) {
        const double unit = pleat.parts * repeat.norm(), width = pleat.width();
        const double growth = std::max(1.0, std::nearbyint(width / unit)) * unit - width;
        choice.fit.strips.push_back({pleat.from, pleat.to, growth});
        choice.change += std::abs(growth);
        choice.possible &= std::abs(growth) <= PleatTuning::kMostGrowth * width;
      }
      choice.possible &= choice.fit.movement() <= most_moved_ + PleatTuning::kWholeCm;
      if (!best_ || isBetter(choice, *best_)) best_ = std::move(choice);
    }
  }

  static bool isBetter(const Choice& one, const Choice& other) {
    if (one.possible != other.possible) return one.possible;
    const double nearer = one.off_grain - other.off_grain;
    if (std::abs(nearer) > PleatTuning::kSameAngle) return nearer < 0;
    return one.change < other.change - PleatTuning::kWholeCm;
  }

  int piece_;
  const PleatedPanel& panel_;
  double most_moved_;
  std::optional<Choice> best_;
};

/// Sentences by code. $ is the list of pieces; 0 and 1 are the first two numbers, in cm.
constexpr struct {
  const char *code, *sentence;
} kFindings[] = {
    {"pleatsFitted",
     "The pleats of $ take up 1 cm in place of 0 cm, a whole repeat, so that the print runs on "
     "across them."},
    {"pleatsOff",
     "The print does not run on across the pleats of $: they take up 0 cm, and a whole repeat is 1 "
     "cm; draft them so, or choose another size of the print."},
    {"pleatsUndivided",
     "Edges of $ run across pleats and count as if these were open; divide them at the lines of "
     "the pleats."},
    {"pleatsOffGrain",
     "No repeat of the print runs across the pleats of $ on this grain; turn the print, or free "
     "the grain."},
    {"pleatsUneven",
     "The print is not matched across the pleats of $, whose lines are not parallel or overlap."}};

enum FindingCode : std::uint8_t { kFitted, kOutOfReach, kUndivided, kOffGrain, kUneven };

class PleatFitting {
 public:
  explicit PleatFitting(Problem* problem) : problem_(*problem) {}

  void fitPiece(int piece) {
    const std::optional<PleatedPanel> pleated = pleatedPanel(problem_.garment.panels[piece]);
    if (!pleated) return find(kUneven, piece);
    const PleatChooser chooser(problem_, piece, *pleated);
    if (!chooser.best()) return find(kOffGrain, piece);
    const Choice& choice = *chooser.best();
    const PleatFit& fit = choice.fit;
    const bool is_divided = isDivided(fit);
    if (!is_divided) find(kUndivided, piece);
    if (choice.change > PleatTuning::kWholeCm) {
      const PleatFit::Strip& first = fit.strips.front();
      const double drafted = first.to - first.from;
      const bool is_fitted = choice.possible && is_divided;
      find(is_fitted ? kFitted : kOutOfReach, piece, {drafted, drafted + first.growth});
      if (!is_fitted) return;
      apply(fit);
    }
    fix(choice);
  }

  /// Stores the fits and adds the notes.
  void end() {
    if (!fits_.empty())
      problem_.pleat_fits = std::make_shared<const std::vector<PleatFit>>(std::move(fits_));
    for (Finding& finding : findings_) {
      std::string names, text;
      for (const int piece : finding.pieces)
        names += (names.empty() ? "" : ", ") + inQuotes(problem_.garment.panels[piece].name);
      for (const char* c = kFindings[finding.code].sentence; *c; ++c) {
        if (*c == '$')
          text += names;
        else if (*c == '0' || *c == '1')
          text += significant(finding.numbers[*c - '0'], 4);
        else
          text += *c;
      }
      problem_.notes.push_back({kFindings[finding.code].code,
                                std::move(text),
                                std::move(finding.pieces),
                                {},
                                std::move(finding.numbers)});
    }
  }

 private:
  /// Pieces about whose pleats the same is to be reported.
  struct Finding {
    FindingCode code;
    std::vector<double> numbers;
    std::vector<int> pieces;
  };

  void find(FindingCode code, int piece, std::vector<double> numbers = {}) {
    for (Finding& finding : findings_)
      if (finding.code == code && finding.numbers == numbers) {
        finding.pieces.push_back(piece);
        return;
      }
    findings_.push_back({code, std::move(numbers), {piece}});
  }

  /// Calls `use` for every curve of a panel.
  template <class Use>
  static void forCurves(Panel& panel, Use use) {
    for (Curve& edge : panel.edges) use(edge);
    for (std::vector<Curve>& hole : panel.holes)
      for (Curve& edge : hole) use(edge);
  }

  /// False if an edge runs across a line of a pleat, or a sewn edge is inside a pleat.
  bool isDivided(const PleatFit& fit) {
    bool is_divided = true;
    forCurves(problem_.garment.panels[fit.piece],
              [&](const Curve& edge) { is_divided &= fit.stripOf(edge) >= -1; });
    for (const Stitch& stitch : problem_.garment.stitches)
      for (const EdgeRef& edge : {stitch.a, stitch.b})
        if (edge.piece == fit.piece)
          is_divided &= fit.stripOf(problem_.garment.panels[edge.piece].edges[edge.edge]) == -1;
    return is_divided;
  }

  void apply(const PleatFit& fit) {
    Panel& panel = problem_.garment.panels[fit.piece];
    const auto move = [&](Vec2& p) { p = fit.fitted(p); };
    forCurves(panel, [&](Curve& edge) { edge = fit.fitted(edge); });
    for (Fold& fold : panel.folds)
      for (Fold::Line* line : {&fold.line, &fold.to})
        for (Vec2& p : *line) move(p);
    for (MatchLine& match : problem_.options.matches) {
      if (match.piece_a == fit.piece)
        for (Vec2& p : match.a) move(p);
      if (match.piece_b == fit.piece)
        for (Vec2& p : match.b) move(p);
    }
    fits_.push_back(fit);
  }

  /// Fixes the angle of the piece and its outline.
  void fix(const Choice& choice) {
    SolveOptions& options = problem_.options;
    const int piece = choice.fit.piece;
    if (options.pins.count(piece) == 0)
      options.piece_grain[piece] = {GrainRule{GrainLock::kOn, 0}, choice.angle + kPi / 2};
    const auto edges = static_cast<int>(problem_.garment.panels[piece].edges.size());
    for (int edge = 0; edge < edges; ++edge) options.locked.push_back({piece, edge});
  }

  Problem& problem_;
  std::vector<Finding> findings_;
  std::vector<PleatFit> fits_;
};

}  // namespace

void fitPleats(Problem* problem) {
  if (problem->options.method != Method::kBest) return;
  const std::vector<int>& plain = problem->options.plain;
  PleatFitting fitting(problem);
  for (std::size_t p = 0; p < problem->garment.panels.size(); ++p) {
    const int piece = static_cast<int>(p);
    bool takes_up = false;
    for (const Fold& fold : problem->garment.panels[p].folds) takes_up |= fold.takesUp();
    if (takes_up && std::find(plain.begin(), plain.end(), piece) == plain.end())
      fitting.fitPiece(piece);
  }
  fitting.end();
}

}  // namespace seamwise
