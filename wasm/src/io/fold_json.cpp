#include "io/fold_json.h"

#include <algorithm>
#include <utility>

#include "geometry/polygon.h"
#include "io/outline_check.h"

namespace seamwise {
namespace {

constexpr double kShortestFoldCm = 0.1;
constexpr double kLeastUptakeCm = 0.1;
constexpr double kFoldOutsideCm = 0.2;  ///< tolerance for lines drawn slightly outside their piece

/// In the order of FoldKind.
constexpr const char* kKinds[] = {"knife", "box", "inverted", "tuck", "roll", "press"};

FoldKind readKind(const JsonValue& json, const Place& place) {
  const std::string kind = text(json, place, "'kind'");
  for (std::size_t k = 0; k < std::size(kKinds); ++k)
    if (kind == kKinds[k]) return static_cast<FoldKind>(k);
  place.fail(place.shape, "has the unknown kind " + inQuotes(kind) +
                              "; write knife, box, inverted, tuck, roll or press");
  return FoldKind::kPress;
}

class FoldReader {
 public:
  FoldReader(const PanelUnits& units, const Panel& panel)
      : cm_(units.cm), mirrored_(panel.mirrored_from_input), outline_(asPolygon(panel.edges)) {
    closed_ = outline_;
    closed_.push_back(outline_.front());
  }

  Fold read(const JsonValue& json, const Place& place) const {
    Fold fold;
    fold.kind = readKind(need(json, "kind", place), place);
    fold.line = fold.to = lineOf(need(json, "line", place), place, "'line'");
    if (json.find("to") || fold.takesUp()) fold.to = lineOf(need(json, "to", place), place, "'to'");
    if (place.failed()) return fold;
    if ((fold.line[1] - fold.line[0]).dot(fold.to[1] - fold.to[0]) < 0)
      std::swap(fold.to[0], fold.to[1]);
    if (fold.takesUp()) checkUptake(fold, place);
    return fold;
  }

 private:
  Fold::Line lineOf(const JsonValue& json, const Place& place, const char* what) const {
    const Polyline points = polyline(json, place, what, cm_);
    if (points.size() != 2 || !((points[1] - points[0]).norm() >= kShortestFoldCm)) {
      place.fail(place.shape,
                 std::string("needs a straight ") + what + " of two distinct points; correct it");
      return {Vec2::Zero(), Vec2::Zero()};
    }
    Fold::Line line{points[0], points[1]};
    for (Vec2& p : line) {
      if (mirrored_) p.x() = 0 - p.x();
      const double off = contains(outline_, p) ? 0 : nearestOnPolyline(closed_, p).distance;
      if (off > kFoldOutsideCm)
        place.fail(place.shape, std::string("has a ") + what + " that ends " + shown(off) +
                                    " cm outside the piece; draw it on the piece");
    }
    return line;
  }

  /// Both ends of `to` are on one side of `line`, and at most one of them is on it.
  static void checkUptake(const Fold& fold, const Place& place) {
    const Vec2 along = (fold.line[1] - fold.line[0]).normalized();
    const double first = cross(along, fold.to[0] - fold.line[0]);
    const double second = cross(along, fold.to[1] - fold.line[0]);
    const double most = std::max(std::abs(first), std::abs(second));
    if (!(most >= kLeastUptakeCm))
      place.fail(place.shape, "has two lines less than " + shown(kLeastUptakeCm) +
                                  " cm apart; draw 'to' where 'line' comes to lie");
    else if (first * second < 0 &&
             std::min(std::abs(first), std::abs(second)) > kLeastUptakeCm / 10)
      place.fail(place.shape, "has lines that cross; draw 'to' beside 'line'");
  }

  double cm_;
  bool mirrored_;
  Polyline outline_, closed_;
};

}  // namespace

void readFolds(const JsonValue& json, const PanelUnits& units, const Place& place, Panel* panel) {
  const FoldReader reader(units, *panel);
  std::size_t n = 0;
  for (const JsonValue& item : array(json, place, "'folds'")) {
    const Place here = numbered(place, "fold", n++);
    panel->folds.push_back(reader.read(object(item, here, "fold"), here));
    if (here.failed()) return;
  }
}

const char* foldKindName(FoldKind kind) { return kKinds[static_cast<std::size_t>(kind)]; }

std::vector<Fold> readPleats(const JsonValue& json, const Place& place) {
  std::vector<Fold> folds;
  for (const JsonValue& item : array(json, place, "'folds'")) {
    const Place here = numbered(place, "fold", folds.size());
    object(item, here, "fold");
    Fold fold;
    fold.kind = readKind(need(item, "kind", here), here);
    for (const auto& [name, line] : {std::pair("line", &fold.line), {"to", &fold.to}}) {
      const Polyline points = polyline(need(item, name, here), here, inQuotes(name));
      if (points.size() != 2 || !((points[1] - points[0]).norm() >= kShortestFoldCm))
        here.fail(here.shape, "is no pleat of a result; align the garment again");
      else
        *line = {points[0], points[1]};
    }
    if (here.failed()) return {};
    folds.push_back(fold);
  }
  return folds;
}

}  // namespace seamwise
