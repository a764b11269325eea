#include "solve/remarks.h"

#include <algorithm>
#include <utility>

#include "base/decimal.h"
#include "base/in_quotes.h"
#include "deform/shape_limits.h"

namespace seamwise {
namespace {

constexpr std::size_t kMostNamed = 4;
constexpr double kOff = 0.1;  ///< least visible mismatch, cm

std::string called(const Pattern& pattern, std::size_t seam) {
  const Seam& s = pattern.seams[seam];
  return decimal(seam) + " (" + inQuotes(pattern.pieces[s.a.piece].name) + " to " +
         inQuotes(pattern.pieces[s.b.piece].name) + ")";
}

}  // namespace

std::vector<Note> remarksOn(const Pattern& pattern) {
  const bool any = std::any_of(pattern.seams.begin(), pattern.seams.end(),
                               [](const Seam& seam) { return seam.matched; });
  if (pattern.seams.empty())
    return {{"noSeams",
             "The garment has no seams, so there is nothing to match; add stitches to its file."}};
  if (!any)
    return {
        {"noMatchedSeams",
         "No seam of the garment is to be matched: each is switched off or joins a plain piece."}};
  std::string list;
  std::vector<int> gathered;
  for (std::size_t s = 0; s < pattern.seams.size(); ++s) {
    const Seam& seam = pattern.seams[s];
    if (!seam.matched || seam.twin || !isGathered(seam)) continue;
    if (gathered.size() < kMostNamed) list += (gathered.empty() ? "" : ", ") + called(pattern, s);
    gathered.push_back(static_cast<int>(s));
  }
  if (gathered.empty()) return {};
  if (gathered.size() > kMostNamed)
    list += " and " + decimal(gathered.size() - kMostNamed) + " more";
  return {
      {"gathered",
       "The two sides of these seams differ by more than a tenth in length (gathers, pleats), so "
       "the print cannot match all along them: " +
           list + "; list them in 'unmatched' to leave them out.",
       {},
       std::move(gathered)}};
}

std::optional<Note> remarkOnRest(const Pattern& pattern, const Shapes& shapes, double worst) {
  if (worst < kOff || !hasDraftedLines(pattern, shapes)) return {};
  return Note{"leftAsDrafted",
              "No shape that the method found fits better than the pieces as drafted, so they keep "
              "their lines."};
}

}  // namespace seamwise
