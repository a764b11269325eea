#include "drape/flat_layout.h"

#include <algorithm>
#include <cmath>

#include "drape/piece_words.h"
#include "drape/seam_arms.h"
#include "drape/vectors.h"

namespace seamwise {
namespace {

// Maximum depth of collar seams below the top of the shoulder pieces. [cm]
constexpr double kNeckline = 18;

}  // namespace

FlatLayout::FlatLayout(const Garment& garment, const Pattern& pattern)
    : garment_(garment),
      pattern_(pattern),
      upright_(garment, pattern),
      count_(static_cast<int>(pattern.pieces.size())),
      arm_(armsBySeams(pattern, upright_)),
      reached_(count_, false),
      at_(count_, Vec2::Zero()),
      neck_(count_, false),
      shoulder_(count_, false) {
  for (int i = 0; i < count_; ++i)
    if (arm_[i] >= 0)
      hold(i);
    else
      holdStrap(i);
  spread(-1);
  for (int i = 0; i < count_; ++i)
    if (arm_[i] == i) spread(i);
  findNeck();
  centreRows();
}

int FlatLayout::unjoined() const {
  for (int i = 0; i < count_; ++i)
    if (!reached_[i]) return i;
  return -1;
}

bool FlatLayout::hasShoulders() const {
  return std::any_of(shoulder_.begin(), shoulder_.end(), [](char is) { return is; });
}

double FlatLayout::apart(const UprightJoin& join) const {
  return std::abs(at_[join.a.piece].x() + join.a.middle.x() - at_[join.b.piece].x() -
                  join.b.middle.x());
}

// Calls use(one, other, join) for both sides of each seam between two pieces.
template <class Use>
void FlatLayout::forSides(const Use& use) const {
  for (const UprightJoin& join : joins())
    if (join.a.piece != join.b.piece) use(join.a, join.b, join), use(join.b, join.a, join);
}

// Turns a piece so that its seams between sleeve and torso are at its top. A grain line has no
// direction, and some files draw sleeves along the arm.
void FlatLayout::hold(int i) {
  Vec2 top = Vec2::Zero();
  forSides([&](const UprightSide& one, const UprightSide& other, const UprightJoin& join) {
    if (one.piece == i && (arm_[other.piece] < 0) != (arm_[i] < 0))
      top += (one.middle - upright_(i, middleOf(i))) * join.length;
  });
  if (arm_[i] >= 0 && std::abs(top.x()) > 2 * std::abs(top.y()))
    upright_.turn(i, top.x() > 0 ? 1 : 3);
  else if (top.y() < 0 && (arm_[i] >= 0 || std::abs(upright_.up(i).y()) < 0.5))
    upright_.turn(i, 2);
}

// A strap between the two ends of a top edge goes around the neck, with its ends at the sides.
void FlatLayout::holdStrap(int i) {
  const UprightSide* ends[2] = {nullptr, nullptr};
  int count = 0;
  forSides([&](const UprightSide& one, const UprightSide& other, const UprightJoin&) {
    if (one.piece != i) return;
    if (++count <= 2 && other.out.y() > 0.5) ends[count - 1] = &one;
  });
  if (count != 2 || !ends[0] || !ends[1]) return;
  const Vec2 way = ends[1]->middle - ends[0]->middle;
  if (ends[0]->out.dot(ends[1]->out) > 0 || planarLength(way) < 0.6 * lengthOf(i)) return;
  neck_[i] = true;
  if (std::abs(way.y()) > std::abs(way.x())) upright_.turn(i, 1);
}

double FlatLayout::lengthOf(int i) const {
  Breadth across, along;
  for (const int v : outline(i)) {
    const Vec2 p = upright_(i, pattern_.pieces[i].rest[v]);
    across.add(p.x()), along.add(p.y());
  }
  return std::max(across.width(), along.width());
}

// Arranges the pieces of one arm, or of the torso for -1, side by side, starting from the piece of
// highest rank. It follows the longest upright seams first, then other flat seams. Shoulder seams
// come last, because their other piece is on the opposite side of the body.
void FlatLayout::spread(int arm) {
  int root = -1;
  for (int i = 0; i < count_; ++i)
    if (arm_[i] == arm && (root < 0 || rank(i) > rank(root))) root = i;
  if (arm < 0) hold(root);
  reached_[root] = true;
  for (;;) {
    int best = -1;
    double most = 0;
    for (std::size_t k = 0; k < joins().size(); ++k) {
      const UprightJoin& join = joins()[k];
      const int a = join.a.piece, b = join.b.piece;
      if (arm_[a] != arm || arm_[b] != arm || reached_[a] == reached_[b]) continue;
      const double score = join.length * (join.isFlat() ? join.isUpright() ? 1e4 : 1e2 : 1);
      if (score > most) most = score, best = static_cast<int>(k);
    }
    if (best >= 0)
      lay(best);
    else if (!layMatched(arm))
      return;
  }
}

double FlatLayout::rank(int i) const {
  return upright_.area(i) * (isCalled(name(i), kFrontWords) ? 4 : 1);
}

void FlatLayout::lay(int k) {
  const bool forwards = reached_[joins()[k].a.piece];
  const int next = (forwards ? joins()[k].b : joins()[k].a).piece;
  // A shoulder seam does not turn a piece: it runs in the other direction on the body's other side.
  const bool flat = joins()[k].isFlat();
  if (flat && !neck_[next])
    upright_.turn(next, forwards ? joins()[k].quarters() : 4 - joins()[k].quarters());
  const UprightSide& from = forwards ? joins()[k].a : joins()[k].b;
  const UprightSide& to = forwards ? joins()[k].b : joins()[k].a;
  at_[next] = at_[from.piece] + from.middle - to.middle;
  if (!flat) at_[next] = at_[from.piece] + Vec2(upright_.width(from.piece), from.top - to.top);
  laid_.push_back({next, from.piece});
  reached_[next] = true;
}

// Places a piece, such as a pocket, that a match joins to a placed one. Returns whether it did.
bool FlatLayout::layMatched(int arm) {
  for (const MatchLine& match : garment_.matches) {
    const int a = match.piece_a, b = match.piece_b;
    if (arm_[a] != arm || arm_[b] != arm || reached_[a] == reached_[b]) continue;
    const Vec2 apart = upright_(a, match.a.front()) - upright_(b, match.b.front());
    const bool forwards = reached_[a];
    at_[forwards ? b : a] = forwards ? Vec2(at_[a] + apart) : Vec2(at_[b] - apart);
    reached_[forwards ? b : a] = true;
    return true;
  }
  return false;
}

double FlatLayout::topOf(int i) const {
  double top = -1e9;
  for (const int v : outline(i)) top = std::max(top, laid(i, v).y());
  return top;
}

// Finds collars and hoods: pieces above the shoulders, pieces with no shoulder piece at their side,
// and pieces attached to these.
void FlatLayout::findNeck() {
  double top = -1e9;
  std::vector<char> beside(count_, false);
  std::vector<double> seam(count_, -1e9);
  forSides([&](const UprightSide& one, const UprightSide& other, const UprightJoin& join) {
    if (arm_[one.piece] < 0 && (join.isShoulder() || arm_[other.piece] >= 0))
      shoulder_[one.piece] = true, top = std::max(top, topOf(one.piece));
  });
  if (top < -1e8) return;
  forSides([&](const UprightSide& one, const UprightSide& other, const UprightJoin& join) {
    if (join.isUpright())
      beside[one.piece] = beside[one.piece] || shoulder_[other.piece];
    else if (one.out.y() < -0.5)
      seam[one.piece] = std::max(seam[one.piece], other.top + at_[other.piece].y());
  });
  for (const auto& [piece, below] : laid_)
    if (arm_[piece] < 0 && !shoulder_[piece])
      neck_[piece] = neck_[piece] || neck_[below] || topOf(piece) > top + 1 ||
                     (!beside[piece] && seam[piece] > top - kNeckline);
}

// Centres a piece over the larger pieces sewn to its top or bottom edge, such as a band over
// gathered panels.
void FlatLayout::centreRows() {
  const double around = ring([&](int i) { return isTorso(i); }).girth;
  for (const std::pair<int, int>& pair : laid_) {
    const int piece = pair.first;
    if (!isTorso(piece)) continue;
    double sum = 0, weight = 0, first = 0;
    forSides([&](const UprightSide& one, const UprightSide& other, const UprightJoin& join) {
      if (one.piece != piece || !isTorso(other.piece) || join.isUpright() || !join.isFlat() ||
          upright_.area(other.piece) < upright_.area(piece))
        return;
      double across = at_[other.piece].x() + other.middle.x() - one.middle.x();
      if (weight == 0) first = across;
      // The layout is cut open somewhere, so a seam across the cut continues one girth further.
      across -= around * std::nearbyint((across - first) / around);
      sum += join.length * across, weight += join.length;
    });
    if (weight > 0) at_[piece].x() = sum / weight;
  }
}

Vec2 FlatLayout::middleOf(int i) const {
  Vec2 middle = Vec2::Zero();
  for (const int v : outline(i)) middle += pattern_.pieces[i].rest[v];
  return middle / static_cast<double>(outline(i).size());
}

}  // namespace seamwise
