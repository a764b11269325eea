#include "marker/pieces_on_board.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace seamwise {
namespace {

/// Steps of positions if the print does not matter or repeats at shorter distances. They are as
/// short as kCells dots in all tables, 2 bytes each, allow, within bounds. Measured on garments and
/// on published packings: steps of a thirtieth of a piece's size cost 3 % of length; the cost of a
/// hundredth is not noticeable.
constexpr double kShortestStep = 0.15, kUsualStep = 0.5;  // cm
constexpr double kCells = 16e6;
constexpr double kLeastShare = 0.1,
                 kMostShare = 4;  ///< shares of kCells at the least and greatest effort
/// Boards of more columns are searched without proofs and without exact checks of near-touching
/// pieces.
constexpr int kFineColumns = 64;
constexpr double kOnEdge = 1e-5;  ///< cm by which pieces may extend beyond a window

bool isMultiple(double angle, double of) {
  return std::abs(angle - of * std::nearbyint(angle / of)) < 1e-6;
}

struct Turn {
  Mat2 linear;
  double angle;
  Vec2 shift;
  int element;
};

/// The allowed rotations of the print under a piece, as motions of the print.
std::vector<Turn> turnsOf(const MarkerProblem& problem, bool ignores_print, LayTurns allowed) {
  if (ignores_print) {
    const Mat2 half = -Mat2::Identity();
    return {{Mat2::Identity(), 0, Vec2::Zero(), 0}, {half, kPi, Vec2::Zero(), 0}};
  }
  const double step = allowed == LayTurns::kHalf      ? kPi
                      : allowed == LayTurns::kQuarter ? kPi / 2
                                                      : kPi / 12;
  std::vector<Turn> turns;
  const auto& elements = problem.group.elements();
  for (std::size_t k = 0; k < elements.size(); ++k)
    if (!elements[k].mirrored && isMultiple(elements[k].angle, step))
      turns.push_back({elements[k].A, elements[k].angle, elements[k].a, static_cast<int>(k)});
  return turns;
}

bool isSame(const Polyline& a, const Polyline& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin());
}

}  // namespace

bool Domain::empty() const {
  return std::all_of(runs.begin(), runs.end(), [](const DotRun& run) { return run.empty(); });
}

PiecesOnBoard::PiecesOnBoard(const MarkerProblem& problem, bool ignores_print)
    : spacing_{problem.gap, ignores_print ? 0 : problem.repeat_tolerance, false},
      ignores_print_(ignores_print) {
  const WallpaperGroup& group = problem.group;
  const auto boardOf = [&](double step) {
    return ignores_print ? Board::square(step) : Board::ofLattice(group.w1(), group.w2(), step);
  };
  board_ = boardOf(kUsualStep);
  if (!ignores_print) period_ = latticePeriod(group.w1(), group.w2(), true);
  items_ = std::vector<LayItem>(problem.pieces.size());
  for (std::size_t k = 0; k < items_.size(); ++k) {
    const MarkerPiece& piece = problem.pieces[k];
    LayItem& item = items_[k];
    item.garment = piece.garment;
    // Pins do not affect the length without the print, with which the print's cost is measured.
    if (piece.pin && ignores_print == problem.ignores_print)
      addPin(piece, problem, &item);
    else
      addWays(piece, problem, &item);
    if (!item.ways.empty()) area_ += shapeOf(item.ways.front()).area;
  }
  double cells = 0;
  for (const PlacedShape& a : placed_)
    for (const PlacedShape& b : placed_)
      cells +=
          tableCells(shapes_[a.shape], shapes_[b.shape], Board::square(kUsualStep), spacing_.gap);
  const double most = kCells * std::clamp(problem.effort, kLeastShare, kMostShare);
  board_ = boardOf(std::max(kShortestStep, kUsualStep * std::sqrt(cells / most)));
  is_fine_ = problem.width / board_.along.x() > kFineColumns;
  is_whole_ = !ignores_print &&
              cross(board_.along, board_.up) < 1.5 * std::abs(cross(group.w1(), group.w2()));
  spacing_.is_exact = !is_fine_;
  for (const Polyline& flaw : problem.flaws)
    flaws_.push_back(seamwise::shapeOf(flaw, Mat2::Identity()));
  for (std::size_t k = 0; k < items_.size(); ++k) {
    const auto same = [&](const LayItem& other) {
      return other.garment == items_[k].garment || problem.nap != Nap::kGarment
                 ? std::equal(other.ways.begin(), other.ways.end(), items_[k].ways.begin(),
                              items_[k].ways.end(),
                              [](const LayWay& a, const LayWay& b) { return a.placed == b.placed; })
                 : false;
    };
    items_[k].like =
        static_cast<int>(std::find_if(items_.begin(), items_.end(), same) - items_.begin());
  }
  tables_.resize(placed_.size() * placed_.size());
}

int PiecesOnBoard::addShape(const Polyline& outline, const Mat2& turn) {
  Shape shape = seamwise::shapeOf(outline, turn);
  const auto known = std::find_if(shapes_.begin(), shapes_.end(),
                                  [&](const Shape& one) { return isSame(one.ring, shape.ring); });
  if (known != shapes_.end()) return static_cast<int>(known - shapes_.begin());
  shapes_.push_back(std::move(shape));
  return static_cast<int>(shapes_.size()) - 1;
}

int PiecesOnBoard::addPlaced(int shape, const Vec2& offset, int item) {
  const auto known = std::find_if(placed_.begin(), placed_.end(), [&](const PlacedShape& one) {
    return !one.is_pinned && one.shape == shape && (one.offset - offset).norm() < 1e-6;
  });
  if (known != placed_.end()) {
    if (known->item != item) known->item = -1;
    return static_cast<int>(known - placed_.begin());
  }
  placed_.push_back({shape, offset, item, false});
  return static_cast<int>(placed_.size()) - 1;
}

void PiecesOnBoard::addWays(const MarkerPiece& piece, const MarkerProblem& problem, LayItem* item) {
  const Mat2 back = piece.alignment.linear().transpose();
  std::vector<Vec2> shifts = {Vec2::Zero()};
  if (!ignores_print_)
    for (const Vec2& shift : piece.shifts) shifts.push_back(shift);
  std::vector<Turn> turns = turnsOf(problem, ignores_print_, piece.turns);
  if (ignores_print_) {  // upright first, so that the search does not depend on the alignment
    const Vec2 head = turns.front().linear * back * piece.up;
    if (head.y() < -1e-6 || (head.y() < 1e-6 && head.x() < 0)) std::swap(turns[0], turns[1]);
  }
  for (const Turn& turn : turns) {
    LayWay way;
    way.linear = turn.linear * back;
    way.angle = wrapAngle(turn.angle - piece.alignment.angle);
    way.element = turn.element;
    way.is_up = (way.linear * piece.up).y() > -1e-6;
    if (problem.nap == Nap::kOneWay) {
      const bool is_kept =
          piece.turns == LayTurns::kHalf ? way.is_up : isMultiple(turn.angle, 2 * kPi);
      if (!is_kept) continue;
    }
    const int shape = addShape(piece.outline, way.linear);
    for (const Vec2& shift : shifts) {
      if (ignores_print_) {
        way.offset = -shapes_[shape].low;
      } else {
        const Vec2 offset = turn.shift - way.linear * piece.alignment.shift + turn.linear * shift;
        const Vec2 steps = board_.steps(offset);
        // Reduce the offset to the cell at the origin for small dots; 1e-6 absorbs rounding.
        const Dot cell{static_cast<int>(std::floor(steps.x() + 1e-6)),
                       static_cast<int>(std::floor(steps.y() + 1e-6))};
        way.offset = offset - board_.shift(cell);
      }
      way.placed = addPlaced(shape, rounded(way.offset), numberOf(item));
      item->ways.push_back(way);
    }
  }
}

void PiecesOnBoard::addPin(const MarkerPiece& piece, const MarkerProblem& problem, LayItem* item) {
  LayWay way;
  way.linear = piece.pin->linear();
  way.angle = piece.pin->angle;
  way.is_up = (way.linear * piece.up).y() > -1e-6;
  const double left = ignores_print_ ? problem.selvedge : problem.phases.front();
  way.offset = piece.pin->shift - Vec2(left, problem.start.value_or(0));
  way.placed = static_cast<int>(placed_.size());
  placed_.push_back(
      {addShape(piece.outline, way.linear), rounded(way.offset), numberOf(item), true});
  item->ways.push_back(way);
  item->is_pinned = true;
}

double PiecesOnBoard::makeTable() {
  if (next_ == tables_.size()) return 0;
  const std::size_t n = placed_.size(), first = next_ / n, second = next_ % n;
  const PlacedShape &a = placed_[first], &b = placed_[second];
  if (a.item >= 0 && a.item == b.item) {  // a piece has only one way at a time
    ++next_;
    return 1;
  }
  tables_[next_] = first > second ? tables_[second * n + first].reversed()
                                  : DifferenceTable(shapes_[a.shape], shapes_[b.shape],
                                                    b.offset - a.offset, board_, spacing_);
  const DifferenceTable& made = tables_[next_++];
  return static_cast<double>(made.rows().size()) * made.columns().size();
}

double PiecesOnBoard::made() const {
  return tables_.empty() ? 1 : static_cast<double>(next_) / static_cast<double>(tables_.size());
}

std::vector<DifferenceTable> PiecesOnBoard::flawTables(int placed, const Vec2& origin) const {
  std::vector<DifferenceTable> tables;
  for (const Shape& flaw : flaws_)
    tables.emplace_back(flaw, shape(placed), origin + placed_[placed].offset, board_,
                        Spacing{0, 0, spacing_.is_exact});
  return tables;
}

Domain PiecesOnBoard::domain(int placed, const Window& window, const Vec2& origin) const {
  const Shape& shape = this->shape(placed);
  const Vec2 start = at(placed, {0, 0}, origin);
  const double left = window.left - shape.low.x() - start.x() - kOnEdge;
  const double right = window.right - shape.high.x() - start.x() + kOnEdge;
  const double bottom = window.bottom - shape.low.y() - start.y() - kOnEdge;
  const double top = window.top - shape.high.y() - start.y() + kOnEdge;
  Domain domain;
  if (right < left || top < bottom) return domain;
  if (placed_[placed].is_pinned) {
    const bool is_in = left <= 0 && right >= 0 && bottom <= 0 && top >= 0;
    if (is_in) domain.runs.push_back({0, 0});
    return domain;
  }
  const Vec2 &along = board_.along, &up = board_.up;
  // Find the rows of dots that may intersect the box.
  double lo = 1e9, hi = -1e9;
  for (const double x : {left, right}) {
    for (const double y : {bottom, top}) {
      const double row = board_.steps({x, y}).y();
      lo = std::min(lo, row);
      hi = std::max(hi, row);
    }
  }
  const int first = static_cast<int>(std::ceil(lo - 1e-9)),
            last = static_cast<int>(std::floor(hi + 1e-9));
  domain.first = first;
  for (int j = first; j <= last; ++j) {
    double from = (left - j * up.x()) / along.x(), to = (right - j * up.x()) / along.x();
    if (std::abs(along.y()) > 1e-9) {
      const double a = (bottom - j * up.y()) / along.y(), b = (top - j * up.y()) / along.y();
      from = std::max(from, std::min(a, b));
      to = std::min(to, std::max(a, b));
    } else if (j * up.y() < bottom || j * up.y() > top) {
      to = from - 2;
    }
    domain.runs.push_back({static_cast<int>(std::ceil(from)), static_cast<int>(std::floor(to))});
  }
  return domain;
}

RigidMotion PiecesOnBoard::place(int item, int way, Dot dot, const Vec2& origin) const {
  const LayWay& by = items_[item].ways[way];
  return {by.angle, origin + by.offset + board_.shift(dot), false};
}

}  // namespace seamwise
