#include "solve/remarks.h"

#include <algorithm>

#include "geometry/in_quotes.h"

namespace seamwise {
namespace {

constexpr int kMostNamed = 4;

std::string called(const Pattern& pattern, std::size_t seam) {
  const Seam& s = pattern.seams[seam];
  return std::to_string(seam) + " (" + inQuotes(pattern.pieces[s.a.piece].name) + " to " +
         inQuotes(pattern.pieces[s.b.piece].name) + ")";
}

}  // namespace

std::vector<std::string> remarksOn(const Pattern& pattern) {
  const bool any = std::any_of(pattern.seams.begin(), pattern.seams.end(),
                               [](const Seam& seam) { return seam.matched; });
  if (pattern.seams.empty())
    return {"The garment has no seams, so there is nothing to match; add stitches to its file."};
  if (!any)
    return {
        "No seam of the garment is to be matched: each is switched off or joins a plain piece."};
  std::string list;
  int count = 0;
  for (std::size_t s = 0; s < pattern.seams.size(); ++s) {
    const Seam& seam = pattern.seams[s];
    if (!seam.matched || seam.twin || !isGathered(seam)) continue;
    if (++count <= kMostNamed) list += (count > 1 ? ", " : "") + called(pattern, s);
  }
  if (count == 0) return {};
  if (count > kMostNamed) list += " and " + std::to_string(count - kMostNamed) + " more";
  return {
      "The two sides of these seams differ by more than a tenth in length (gathers, pleats), so "
      "the print cannot match all along them: " +
      list + "; list them in 'unmatched' to leave them out."};
}

}  // namespace seamwise
