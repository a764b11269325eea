#include "drape/worn_garment.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/decimal.h"
#include "drape/closed_bands.h"
#include "drape/fitting_form.h"
#include "drape/layers.h"
#include "drape/missing_girth.h"
#include "drape/tied_bands.h"
#include "drape/turn.h"
#include "drape/wrap.h"

namespace seamwise {
namespace {

constexpr double kUsualBudget = 170;  ///< work, in factorisations of a 90 x 90 grid
/// Maximum area of cloth, more than the widest gown has. A larger garment needs much of the budget
/// for a single step. [m2]
constexpr double kMostCloth = 20;
/// Lengths of waves at the start, relative to six bending lengths of the fabric. The drape keeps
/// the one that hangs with the least energy, if the garment is fuller than the body by kFull. [1]
constexpr std::array<double, 3> kWaves{1, 0.65, 1.6};
constexpr double kFull = 1.3;
/// Length of fold below which the coarse mesh cannot follow the shortest waves. [cm]
constexpr double kLeastFold = 1.8;
constexpr double kBelowCrotch = 1;  ///< cm, depth at which trouser legs are separate
// Limits of a wearable garment. The samples reach at most 0.05 tension in poplin, 0.0005 m depth,
// and 0.05 crossings per triangle.
constexpr double kFarthestFall = 0.25;   ///< m, of the highest vertex
constexpr double kMostTension = 0.05;    ///< 99th percentile, beyond Fabric::stiff_from
constexpr double kMostDepth = 0.005;     ///< m, inside the form
constexpr double kMostCrossings = 0.08;  ///< per triangle

/// Returns the measurements of the settings, the file or its size. Without any, it fits a body and
/// lifts the garment to that body's height.
Outcome<Measures> measuresFor(SolvedGarment* solved, const WearSettings& settings) {
  if (settings.measures) return *settings.measures;
  Garment& garment = solved->garment;
  const Measures* of_size = measuresOf(garment.size);
  Measures measures = of_size ? *of_size : *measuresOf("m");
  if (!of_size && garment.body.empty()) {
    const Outcome<FittingForm> fitting = fittingForm(garment, solved->pattern);
    if (!fitting.ok()) return fitting.error();
    for (Panel& panel : garment.panels) panel.placement_shift.y() += fitting.value().lift;
    return fitting.value().measures;
  }
  for (const BodyMeasure& measure : garment.body)
    for (const MeasureName& known : kMeasureNames)
      if (known.name == measure.name) measures.*known.value = measure.cm;
  return measures;
}

/// Clears a placement that all pieces share, because it does not place them on a body.
void forgetCommonPlacement(Garment* garment) {
  const Panel first = garment->panels.front();
  for (const Panel& panel : garment->panels)
    if (panel.placement_shift != first.placement_shift ||
        panel.placement_turn != first.placement_turn)
      return;
  for (Panel& panel : garment->panels) panel.placement_shift = panel.placement_turn = Vec3::Zero();
}

template <class T>
std::vector<T> permuted(std::vector<T> list, const std::vector<int>& order) {
  std::vector<T> result;
  result.reserve(order.size());
  for (int i : order) result.push_back(std::move(list[i]));
  return result;
}

/// Returns the garment with its pieces in another order.
SolvedGarment ordered(SolvedGarment garment, const std::vector<int>& order) {
  std::vector<int> place(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = static_cast<int>(i);
  garment.garment.panels = permuted(std::move(garment.garment.panels), order);
  garment.pattern.pieces = permuted(std::move(garment.pattern.pieces), order);
  garment.shapes = permuted(std::move(garment.shapes), order);
  for (MatchLine& match : garment.garment.matches)
    match.piece_a = place[match.piece_a], match.piece_b = place[match.piece_b];
  for (Seam& seam : garment.pattern.seams)
    seam.a.piece = place[seam.a.piece], seam.b.piece = place[seam.b.piece];
  for (Mirror& mirror : garment.pattern.mirrors)
    for (int& piece : mirror.pieces) piece = place[piece];
  return garment;
}

/// Returns the vertices of a level from an earlier drape, or nothing if they belong to another
/// garment or another form. [m]
Positions settledOf(const SewnLevel& level, const std::vector<double>& flat,
                    const DistanceField& body) {
  constexpr double kDeepest = 0.005;  // m, tolerated depth of a changed shape in the form
  if (flat.size() != 3 * static_cast<std::size_t>(level.size)) return {};
  Positions settled;
  for (std::size_t k = 0; k < flat.size(); k += 3) {
    const Vec3 at = kCentimetre * Vec3(flat[k], flat[k + 1], flat[k + 2]);
    if (!at.allFinite() || body.distance(at, nullptr) < -kDeepest) return {};
    settled.push_back(at);
  }
  return settled;
}

/// Returns an error if the garment has too much cloth to be one.
std::optional<Error> tooMuchCloth(const Pattern& pattern) {
  double area = 0;
  for (const Piece& piece : pattern.pieces)
    for (const auto& triangle : piece.triangles)
      area += triangleArea(piece.rest, triangle) * kCentimetre * kCentimetre;
  if (area <= kMostCloth) return std::nullopt;
  return Error{Failure::kNotAGarment,
               "The garment takes " + decimal(static_cast<std::int64_t>(area)) +
                   " m2 of fabric, more than the " +
                   decimal(static_cast<std::int64_t>(kMostCloth)) +
                   " m2 that can be draped; check the units of its file.",
               -1, -1, "drapeTooLarge"};
}

/// Returns the length at which a fabric bends around the body under its own weight. [cm]
double foldOf(const Fabric& fabric) {
  const double cubic_metres = fabric.bending_weft / (fabric.density * kGravity);
  double metres = 0.02;
  // Newton's method for the cubic root; the library's one depends on the platform.
  for (int k = 0; k < 20; ++k) metres -= (metres - cubic_metres / (metres * metres)) / 3;
  return metres / kCentimetre;
}

double topOf(const Positions& positions) {
  double top = -1e9;
  for (const Vec3& at : positions) top = std::max(top, at.y());
  return top;
}

/// Returns the start positions of a level's sewn vertices from those of its pieces. [m]
Positions startOf(const SewnLevel& level, const PiecePositions& wrapped) {
  Positions start(level.size, Vec3::Zero());
  for (std::size_t p = 0; p < wrapped.size(); ++p)
    for (std::size_t v = 0; v < wrapped[p].size(); ++v)
      start[level.sewn[p][v]] = kCentimetre * wrapped[p][v];
  return start;
}

}  // namespace

double WornGarment::Body::distance(const Vec3& p, Vec3* gradient) const {
  return kCentimetre * form_->distance(p / kCentimetre, parts_, gradient);
}

WornGarment::WornGarment(SolvedGarment garment, Form form, Hanging hanging, SewnLevels levels,
                         std::vector<int> order)
    : garment_(std::move(garment)),
      form_(std::move(form)),
      hanging_(std::move(hanging)),
      levels_(std::move(levels)),
      order_(std::move(order)),
      body_(form_, hanging_.covered()) {}

/// Wraps the coarse level in waves of six times `fold` cm. [m]
Outcome<Positions> WornGarment::startWith(double fold, double* fullness) const {
  WrapSettings settings;
  settings.fold = fold;
  const Outcome<PiecePositions> start =
      wrapped(garment_.garment, levels_.coarse.pattern, form_, settings, fullness);
  if (!start.ok()) return start.error();
  return startOf(levels_.coarse, start.value());
}

Outcome<std::unique_ptr<WornGarment>> WornGarment::make(SolvedGarment garment,
                                                        const WearSettings& settings) {
  if (const auto error = tooMuchCloth(garment.pattern)) return *error;
  forgetCommonPlacement(&garment.garment);
  const Outcome<Measures> measures = measuresFor(&garment, settings);
  if (!measures.ok()) return measures.error();
  Outcome<Form> form = Form::make(measures.value());
  if (!form.ok()) return form.error();
  const Outcome<Hanging> as_listed = hang(garment.garment, garment.pattern, form.value());
  if (!as_listed.ok()) return as_listed.error();
  std::vector<int> order = as_listed.value().order;
  garment = ordered(std::move(garment), order);
  closeBands(&garment.pattern);
  Outcome<Hanging> hanging = hang(garment.garment, garment.pattern, form.value());
  if (!hanging.ok()) return hanging.error();
  tieBands(hanging.value(), form.value(), &garment.pattern);
  Outcome<SewnLevels> levels =
      sewnLevels(garment.pattern, kCoarseCloth / kFineCloth * settings.edge, settings.edge,
                 pleatsOf(garment.garment, garment.pattern));
  if (!levels.ok()) return levels.error();
  std::unique_ptr<WornGarment> worn(new WornGarment(std::move(garment), std::move(form).value(),
                                                    std::move(hanging).value(),
                                                    std::move(levels).value(), std::move(order)));
  const SewnLevel& coarse = worn->levels_.coarse;
  DrapeProblem problem;
  problem.settled = settledOf(worn->levels_.fine, settings.settled, worn->body_);
  const double fold = std::max(kLeastFold, foldOf(settings.fabric));
  double fullness = 0;
  auto start = worn->startWith(kWaves[0] * fold, &fullness);
  if (!start.ok()) return start.error();
  problem.start = std::move(start).value();
  if (fullness > kFull) {
    problem.other_starts = static_cast<int>(kWaves.size()) - 1;
    problem.other_start = [own = worn.get(), fold](int k) {
      return own->startWith(kWaves[k + 1] * fold).value();  // the first one was possible
    };
  }
  problem.levels = worn->levels_;
  problem.pattern = worn->garment_.pattern;
  problem.shapes = worn->garment_.shapes;
  for (const Panel& panel : worn->garment_.garment.panels) {
    const Turn turn = turnOfDegrees(degreesOf(panel.grain_angle));
    problem.warp.emplace_back(turn.cosine, turn.sine);
  }
  problem.by_band = hangsFromWaist(worn->hanging_, problem.pattern, worn->form_);
  problem.matches = worn->garment_.garment.matches;
  problem.overlaps = overlapsOf(worn->garment_.garment, coarse.pattern, worn->hanging_);
  for (const BodyPart part : worn->hanging_.parts)
    problem.legs.push_back(part == BodyPart::kLeftLeg ? 1 : part == BodyPart::kRightLeg ? -1 : 0);
  problem.crotch = kCentimetre * (worn->form_.crotchHeight() - kBelowCrotch);
  problem.fabric = settings.fabric;
  problem.body = &worn->body_;
  worn->top_ = topOf(problem.settled.empty() ? problem.start : problem.settled);
  problem.effort = settings.effort;
  problem.budget = kUsualBudget * settings.effort;
  worn->drape_ = std::make_unique<Drape>(std::move(problem));
  return worn;
}

Pattern WornGarment::asCut() const {
  Pattern pattern = garment_.pattern;
  for (std::size_t p = 0; p < pattern.pieces.size(); ++p)
    pattern.pieces[p].rest = garment_.shapes[p];
  return pattern;
}

std::optional<Error> WornGarment::refusal() const {
  const auto refused = [](const char* reason, const std::string& what) {
    return Error{Failure::kNotAGarment,
                 what +
                     ": give the measurements of the body that it is drafted for, or look at how "
                     "its pieces are sewn.",
                 -1, -1, reason};
  };
  if (topOf(drape_->positions()) < top_ - kFarthestFall)
    return refused("drapeSlides", "The garment slides off the form");
  if (drape_->stage() != Drape::Stage::kDone) return std::nullopt;
  const DrapeCheck& check = drape_->check();
  if (check.worn > kMostTension + drape_->fabric().stiff_from || check.depth > kMostDepth) {
    const std::optional<MissingGirth> girth = missingGirth(garment_.garment, asCut(), form_);
    return refused("drapeTooSmall", "The garment is too small for its form" +
                                        (girth ? spoken(*girth) : std::string()));
  }
  std::size_t triangles = 0;
  for (const Piece& piece : levels_.fine.pattern.pieces) triangles += piece.triangles.size();
  if (check.crossings > kMostCrossings * static_cast<double>(triangles))
    return refused("drapeTangled", "The garment's pieces lie in a tangle on the form");
  return std::nullopt;
}

}  // namespace seamwise
