#include "drape/weld.h"

#include <numeric>

#include "base/disjoint_sets.h"

namespace seamwise {
namespace {

std::vector<int> imagesOf(const Pattern& pattern, const Weld& weld) {
  std::vector<int> image(weld.members.size(), -1);
  bool fits = true;
  const auto map = [&](int from, int to) {
    fits = fits && (image[from] < 0 || image[from] == to);
    image[from] = to;
  };
  for (const Mirror& mirror : pattern.mirrors)
    for (std::size_t v = 0; v < mirror.image.size(); ++v) {
      const int a = weld.knot[mirror.pieces[0]][v];
      const int b = weld.knot[mirror.pieces[1]][mirror.image[v]];
      map(a, b);
      map(b, a);
    }
  for (int to : image) fits = fits && to >= 0;
  return fits ? image : std::vector<int>{};
}

}  // namespace

Weld welded(const Pattern& pattern, const std::vector<int>& order) {
  std::vector<int> first(pattern.pieces.size());
  int count = 0;
  for (int p : order) {
    first[p] = count;
    count += static_cast<int>(pattern.pieces[p].rest.size());
  }
  DisjointSets sets(count);
  for (const Seam& seam : pattern.seams)
    for (std::size_t i = 0; i < seam.a.vertices.size(); ++i)
      sets.join(first[seam.a.piece] + seam.a.vertices[i], first[seam.b.piece] + seam.b.vertices[i]);
  Weld weld;
  weld.knot.resize(pattern.pieces.size());
  std::vector<int> number(count, -1);
  for (int p : order)
    for (std::size_t v = 0; v < pattern.pieces[p].rest.size(); ++v) {
      int& knot = number[sets.find(first[p] + static_cast<int>(v))];
      if (knot < 0) {
        knot = static_cast<int>(weld.members.size());
        weld.members.emplace_back();
      }
      weld.knot[p].push_back(knot);
      weld.members[knot].push_back({p, static_cast<int>(v)});
    }
  weld.image = imagesOf(pattern, weld);
  return weld;
}

Weld welded(const Pattern& pattern) {
  std::vector<int> order(pattern.pieces.size());
  std::iota(order.begin(), order.end(), 0);
  return welded(pattern, order);
}

}  // namespace seamwise
