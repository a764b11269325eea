#include "drape/ring.h"

#include <algorithm>
#include <cmath>

#include "base/sort_by.h"
#include "drape/tied_bands.h"
#include "drape/turn.h"

namespace seamwise {
namespace {

// Girths relative to the body: minimum of a ring, threshold for waves, base of waves. The girth of
// a spiral is relative to that minimum. [1]
constexpr double kEase = 1.06, kWavesFrom = 1.06, kWaveBase = 1, kSpiral = 1.05;
// Number of levels on either side over which rings are smoothed. [cm]
constexpr int kSmoothing = 3;
// Minimum length above a hem; shorter rings are bands or tiers. [cm]
constexpr int kAboveHem = 8;
// Minimum difference in height between uneven hems. [cm]
constexpr int kUneven = 2;
// Share of its length that a band uses to go around once; the rest overlaps. [1]
constexpr double kLapped = 0.93;
// Distance between layers of a band that overlaps itself. [cm]
constexpr double kTurnOffset = 0.6;
// Additional layers per turn of a spiral. [1]
constexpr double kSpiralLayers = 4;
// Drop behind the fold over which a folded end moves one layer outwards. [cm]
constexpr double kFoldOver = 1;

double nearTurn(double degrees, double to) {
  return degrees - 360 * std::nearbyint((degrees - to) / 360);
}

// Returns the mean without the smallest two sevenths and the largest two sevenths of the values.
// Levels where tiers meet have too many or too few pieces.
double middleMean(std::vector<double> values) {
  sortNumbers(values);
  const std::size_t drop = values.size() * 2 / 7;
  double sum = 0;
  for (std::size_t k = drop; k + drop < values.size(); ++k) sum += values[k];
  return sum / static_cast<double>(values.size() - 2 * drop);
}

}  // namespace

double Ring::girthOfTies(const Tube& tube, double level) {
  return kSpiral * kEase * tube.section(level).girth();
}

Ring::Ring(const Tube& tube, const Pattern& pattern, std::vector<RingPiece> pieces, double fold)
    : tube_(tube), pieces_(std::move(pieces)), fold_(fold) {
  double low = 1e9, high = -1e9;
  for (RingPiece& piece : pieces_) {
    piece.bottom = 1e9, piece.top = -1e9;
    for (const Vec2& p : piece.flat)
      piece.bottom = std::min(piece.bottom, p.y()), piece.top = std::max(piece.top, p.y());
    low = std::min(low, piece.bottom), high = std::max(high, piece.top);
  }
  sortBy(pieces_, [](const RingPiece& piece) { return piece.angle; });
  findFlanks(pattern, &pieces_);
  findHems(pattern, &pieces_);
  low = std::min(low, findTies(pattern));
  bottom_ = std::floor(low);
  for (int i = 0; levelOf(i) < high + 1; ++i) levels_.push_back(levelAt(levelOf(i)));
  levelHem();
  smooth();
  for (std::size_t i = 0; i < levels_.size(); ++i) draw(levels_[i], levelOf(static_cast<int>(i)));
}

double Ring::findTies(const Pattern& pattern) {
  double lowest = 1e9;
  for (RingPiece& piece : pieces_) {
    for (const Seam& seam : pattern.seams)
      if (seam.a.piece == piece.piece && !piece.inRing())
        piece.tied = std::max(piece.tied, tiedAt(seam, piece.flat));
    const Vec2 extent = piece.extent((piece.bottom + piece.top) / 2);
    if (piece.tied > 0)
      lowest = std::min(lowest, piece.bottom + piece.tied - (extent.y() - extent.x()) / 2);
  }
  return lowest;
}

Ring::Level Ring::levelAt(double level) const {
  const std::size_t count = pieces_.size();
  Level out;
  out.turn.resize(count), out.middle.resize(count), out.stretch.assign(count, 1);
  std::vector<double> centre(count, 0.0);
  double width = 0, actual = 0, widest_open = 0, around = 0;
  bool closed = true, any = false;
  for (std::size_t i = 0; i < count; ++i) {
    const RingPiece& piece = pieces_[i];
    const Vec2 here = piece.extent(level);
    out.middle[i] = (here.x() + here.y()) / 2;
    if (!piece.reaches(level)) continue;
    if (!piece.inRing()) {
      if (piece.tied > 0)
        around = girthOfTies(tube_, level);
      else
        widest_open = std::max(widest_open, here.y() - here.x());
      continue;
    }
    // A side continues vertically past the ends of its seam; an open side ends where the other one
    // does.
    const auto side = [&](const RingPiece::Flank& own, const RingPiece::Flank& other, int which) {
      const RingPiece::Flank& flank = own.sewn() ? own : other;
      return piece.extent(std::clamp(level, flank.low, flank.high))[which];
    };
    const double left = side(piece.left, piece.right, 0);
    const double right = side(piece.right, piece.left, 1);
    out.middle[i] = (left + right) / 2;
    centre[i] = width + (right - left) / 2;
    width += right - left;
    actual += here.y() - here.x();
    closed = closed && piece.left.covers(level) && piece.right.covers(level);
    any = true;
  }
  const double body = tube_.section(level).girth() * kEase;
  if (!any) {
    // Bands longer than 1.6 sections go around in a spiral.
    out.spiral = widest_open >= 1.6 * body;
    out.girth = out.spiral ? kSpiral * body : std::max({body, around, kLapped * widest_open});
    for (std::size_t i = 0; i < count; ++i) out.turn[i] = pieces_[i].angle;
    return out;
  }
  out.girth = std::max(body, closed ? width : std::min(width, actual));
  if (closed) out.width = width;
  const double whole = closed ? width : std::max(width, std::min(out.girth, actual));
  const double stretch = out.girth / whole;  // makes sewn sides meet
  const double open_stretch = closed ? stretch : std::min(1.0, out.girth / actual);
  // Turns the ring so that its pieces have their given angles in the mean.
  double sum = 0, first = 0;
  int voters = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const RingPiece& piece = pieces_[i];
    const bool here = piece.inRing() && centre[i] > 0;
    if (!here) continue;
    const double off = piece.angle - 360 * centre[i] / whole;
    if (voters == 0) first = off;
    sum += nearTurn(off, first);
    ++voters;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const bool here = pieces_[i].inRing() && centre[i] > 0;
    out.turn[i] = here ? nearTurn(360 * centre[i] / whole + sum / voters, pieces_[i].angle)
                       : pieces_[i].angle;
    if (here) out.stretch[i] = pieces_[i].isSewnAt(level) ? stretch : open_stretch;
  }
  return out;
}

// Continues a ring unchanged below the hem of its shortest piece. A back that is longer than the
// fronts is no ring there.
void Ring::levelHem() {
  const int count = static_cast<int>(levels_.size());
  const auto reach = [&](int from, int to) {
    return std::all_of(pieces_.begin(), pieces_.end(), [&](const RingPiece& piece) {
      return !piece.inRing() || !piece.reaches(levelOf(from)) || piece.reaches(levelOf(to));
    });
  };
  const auto begins = [&](int at) {
    return std::any_of(pieces_.begin(), pieces_.end(), [&](const RingPiece& piece) {
      return piece.inRing() && piece.hem && piece.reaches(levelOf(at)) &&
             !piece.reaches(levelOf(at - 1));
    });
  };
  int lowest = 0, hem = 0;
  for (int i = 1; i + kAboveHem < count && reach(i - 1, i); ++i)
    if (begins(i)) hem = i, lowest = lowest > 0 ? lowest : i;
  // This excludes tiers, because their lowest pieces end soon above the hem.
  if (hem - lowest >= kUneven && reach(hem, hem + kAboveHem))
    std::fill_n(levels_.begin(), hem, levels_[hem]);
}

void Ring::smooth() {
  const std::vector<Level> rough = levels_;
  const int count = static_cast<int>(levels_.size());
  for (int i = 0; i < count; ++i) {
    const int from = std::max(0, i - kSmoothing), to = std::min(count - 1, i + kSmoothing);
    Level& level = levels_[i];
    std::vector<double> girths, widths;
    for (int k = from; k <= to; ++k)
      girths.push_back(rough[k].girth), widths.push_back(rough[k].width);
    level.girth = middleMean(girths), level.width = middleMean(widths);
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      // Only levels that the piece reaches count.
      std::vector<double> turns, stretches;
      for (int k = from; k <= to; ++k)
        if (pieces_[p].reaches(levelOf(k)))
          turns.push_back(rough[k].turn[p]), stretches.push_back(rough[k].stretch[p]);
      if (turns.empty()) continue;
      level.turn[p] = middleMean(turns), level.stretch[p] = middleMean(stretches);
    }
  }
}

// Returns the girth that cloth hangs around at a level: the largest section that it passes on the
// way down. [cm]
double Ring::hungGirth(double level) const {
  constexpr double kAbove = 30;
  double most = tube_.section(level).girth();
  for (double at = level; at < std::min(level + kAbove, levelOf(static_cast<int>(levels_.size())));
       at += 2)
    most = std::max(most, tube_.section(at).girth());
  return most;
}

std::vector<std::pair<double, double>> Ring::closedWidths(int without) const {
  std::vector<double> widths;
  for (std::size_t i = 0; i < levels_.size(); ++i)
    widths.push_back(levelAt(levelOf(static_cast<int>(i))).width);
  // Pieces are missing at up to three levels where tiers meet. The result is the narrowest of the
  // maxima over four neighbours.
  const int count = static_cast<int>(widths.size());
  const auto widest = [&](int from) {
    if (from < 0 || from + 3 >= count) return 1e9;
    return std::max({widths[from], widths[from + 1], widths[from + 2], widths[from + 3]});
  };
  std::vector<std::pair<double, double>> closed;
  for (int i = without; i < count; ++i) {
    const double width = std::min({widest(i - 3), widest(i - 2), widest(i - 1), widest(i)});
    if (widths[i] > 0 && width < 1e9) closed.emplace_back(levelOf(i), width);
  }
  return closed;
}

void Ring::draw(Level& level, double at) {
  const Section section = tube_.section(at);
  const double hung = hungGirth(at);
  const bool waves = fold_ > 0 && level.width > kWavesFrom * hung;
  if (waves) fullness_ = std::max(fullness_, level.width / hung);
  const Section base = section.withGirth(waves ? kWaveBase * hung : level.girth);
  const std::vector<Vec2> corners = base.polygon();
  const int fine = 4, count = static_cast<int>(corners.size()) * fine;
  const double folds = waves ? std::max(2.0, std::nearbyint(level.girth / (6 * fold_))) : 0;
  const auto line = [&](double amplitude) {
    std::vector<Vec2> out;
    for (int k = 0; k < count; ++k) {
      const double share = static_cast<double>(k % fine) / fine;
      Vec2 p = corners[k / fine] * (1 - share) + corners[(k / fine + 1) % corners.size()] * share;
      const double wave = 1 + amplitude * (1 - turnOfDegrees(folds * 360 * k / count).cosine);
      out.push_back({p.x() * wave, section.middle + (p.y() - section.middle) * wave});
    }
    return out;
  };
  const auto girthOf = [](const std::vector<Vec2>& polygon) {
    double sum = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k)
      sum += planarLength(Vec2(polygon[(k + 1) % polygon.size()] - polygon[k]));
    return sum;
  };
  level.line = line(0);
  if (waves) {
    double low = 0, high = 1;
    for (int step = 0; step < 24; ++step) {
      const double middle = (low + high) / 2;
      (girthOf(line(middle)) < level.girth ? low : high) = middle;
    }
    level.line = line(low);
  }
  level.arc.assign(1, 0.0);
  for (int k = 0; k < count; ++k)
    level.arc.push_back(level.arc.back() +
                        planarLength(Vec2(level.line[(k + 1) % count] - level.line[k])));
}

Vec2 Ring::onLine(const Level& level, double arc) const {
  const double whole = level.arc.back(), turns = std::floor(arc / whole);
  const double rest = arc - turns * whole;
  const auto next = std::upper_bound(level.arc.begin() + 1, level.arc.end() - 1, rest);
  const std::size_t k = next - level.arc.begin() - 1, count = level.line.size();
  const double share = (rest - level.arc[k]) / (level.arc[k + 1] - level.arc[k]);
  return level.line[k] * (1 - share) + level.line[(k + 1) % count] * share;
}

Vec3 Ring::position(int index, int vertex, double outward) const {
  const RingPiece& piece = pieces_[index];
  Vec2 p = piece.flat[vertex];
  const double middle = levels_[below(p.y())].middle[index], side = p.x() < middle ? -1 : 1;
  if (piece.tied > 0) p = piece.folded(p, middle);
  const double tail = (piece.flat[vertex].y() - p.y()) / kFoldOver;
  const auto on = [&](const Level& level) -> Vec2 {
    const double whole = level.arc.back(), front = level.turn[index] / 360 * whole;
    const auto at = [&](double arc, double layers) -> Vec2 {
      const double further = outward + kTurnOffset * layers;
      return onLine(level, front + arc) * (1 + further * 2 * kPi / whole);
    };
    if (piece.tied > 0) {
      // The end keeps its width beside the knot; the part before it takes the remaining length of
      // the ring.
      const double width = piece.top - piece.bottom, before = piece.tied - width;
      const double out =
          p.x() > before ? whole / 2 - (piece.tied - p.x()) : p.x() * (whole / 2 - width) / before;
      return at(side * out, std::clamp(tail, 0.0, 1.0));
    }
    const double ahead = (p.x() - level.middle[index]) * level.stretch[index];
    if (piece.inRing()) return at(ahead, 0);
    const double turns = std::abs(ahead) / whole - 0.5;
    // The right end of a band that goes around once overlaps the left one.
    const double lap = ahead > 0 ? std::clamp(turns * 20 + 1, 0.0, 1.0) : 0;
    const double more = std::max(0.0, turns), next = std::min(more * 20, 1.0);
    // The two ends of a spiral cross each other twice a turn, in other layers each time.
    return at(ahead, level.spiral ? lap + next + kSpiralLayers * more
                                  : std::max(lap, std::min(more * 20, 1.0 + more)));
  };
  const int k = below(p.y());
  const double share = std::clamp(p.y() - levelOf(k), 0.0, 1.0);
  const Vec2 q = on(levels_[k]) * (1 - share) + on(levels_[k + 1]) * share;
  return tube_.axis().world({q.x(), q.y(), p.y()});
}

}  // namespace seamwise
