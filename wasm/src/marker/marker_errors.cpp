#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "base/decimal.h"
#include "marker/marker.h"

namespace seamwise {
namespace {

/// Greatest additional width that is tried for a piece that does not fit, and its steps. [cm]
constexpr double kMostWider = 200, kWider = 0.5;

std::string centimetres(double length) { return fixed(length, 1) + " cm"; }
/// A length rounded up, so that fabric of that width is wide enough.
std::string atLeast(double length) { return centimetres(std::ceil(10 * length - 1e-4) / 10); }

/// An error about a piece, by its index in the problem. Its reason is part of the API. The page
/// reads the least width of the fabric from the end of the message.
Error about(std::size_t piece, const char* reason, std::string message, double width = 0) {
  if (width > 0) message += "; the fabric has to be at least " + atLeast(width) + " wide";
  return {Failure::kOptions, message + ".", static_cast<int>(piece), -1, reason};
}

}  // namespace

Outcome<std::unique_ptr<Marker>> Marker::make(MarkerProblem problem) {
  if (problem.pieces.empty()) return Error{Failure::kOptions, "There is no piece to lay."};
  const double room = problem.width - 2 * problem.selvedge;
  std::unique_ptr<Marker> marker(new Marker(std::move(problem)));
  for (std::size_t k = 0; k < marker->problem_.pieces.size(); ++k) {
    const MarkerPiece& piece = marker->problem_.pieces[k];
    const std::vector<LayWay>& ways = marker->pieces_.items()[k].ways;
    if (ways.empty())
      return about(k, "layUpright",
                   piece.name + " cannot lie with its upper end up on this print; allow both ways");
    double least = std::numeric_limits<double>::infinity();
    for (const LayWay& way : ways) {
      const Shape& shape = marker->pieces_.shapeOf(way);
      least = std::min(least, shape.high.x() - shape.low.x());
    }
    if (!piece.pin && least > room + 1e-5)
      return about(k, "layTooWide",
                   piece.name + " is " + atLeast(least) + " wide, more than the " +
                       centimetres(std::max(room, 0.0)) + " between the selvedges",
                   least + 2 * marker->problem_.selvedge);
  }
  return marker;
}

void Marker::fail() {
  const LayoutSearch& search = *variants_.front().search;
  const int item = std::max(search.homeless(), 0);
  const MarkerPiece& piece = problem_.pieces[item];
  stage_ = Stage::kDone;
  if (piece.pin) {
    error_ =
        about(item, "layPinned",
              piece.name + " cannot lie where it is pinned, over a pin, flaw or edge; move it");
    return;
  }
  if (!problem_.flaws.empty()) {
    error_ = about(item, "layFlaws",
                   piece.name + " finds no place between the flaws; take fabric with fewer");
    return;
  }
  const std::string nowhere =
      "On this repeat " + piece.name + " fits nowhere across " + centimetres(problem_.width);
  for (double width = problem_.width; width < problem_.width + kMostWider; width += kWider) {
    for (const double phase : problem_.phases) {
      const LayFabric fabric = fabricOf(width, phase);
      const Window window{fabric.left, fabric.right, 0, 1000};
      for (const LayWay& way : pieces_.items()[item].ways) {
        if (pieces_.domain(way.placed, window, fabric.origin).empty()) continue;
        error_ = about(item, "layNowhere", nowhere, width);
        return;
      }
    }
  }
  error_ = about(item, "layNowhere", nowhere);
}

}  // namespace seamwise
