// Layouts of the same pieces without the print, and on fabrics of other widths.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "marker/marker.h"
#include "tuning/marker.h"

namespace seamwise {

void Marker::layFree() {
  if (!problem_.also_free || problem_.ignores_print) {
    if (problem_.ignores_print) free_length_ = length();
    stage_ = Stage::kWidths;
    return;
  }
  if (!free_pieces_) {
    free_pieces_ = std::make_unique<PiecesOnBoard>(problem_, true);
    reads_ += MarkerTuning::kReadsOfShapes;
    return;
  }
  if (!free_search_) {
    const double dots = free_pieces_->makeTable();
    reads_ += MarkerTuning::kReadsOfTable + MarkerTuning::kReadsOfDot * dots;
    if (dots > 0) return;
    LayFabric fabric = fabricOf(problem_.width, 0);
    fabric.origin = {fabric.left, 0};
    fabric.turned_down = best_search_->fabric().turned_down;
    free_search_ = std::make_unique<LayoutSearch>(*free_pieces_, fabric, problem_.seed);
  }
  if (goOn(*free_search_, budget())) return;
  // A layout on the print is also one without it.
  free_length_ = free_search_->best() ? std::min(free_search_->best()->length(), best_->length())
                                      : best_->length();
  stage_ = Stage::kWidths;
}

void Marker::layWidths() {
  if (width_ == problem_.widths.size()) {
    stage_ = Stage::kDone;
    return;
  }
  const double width = problem_.widths[width_];
  if (!width_search_) {
    LayFabric fabric = best_search_->fabric();
    fabric.right = width - problem_.selvedge;
    width_search_ = std::make_unique<LayoutSearch>(pieces_, fabric, problem_.seed);
    // A layout on narrower fabric also fits on this one.
    if (width >= problem_.width) width_search_->offer(*best_);
    if (narrower_ && narrower_->best() && width >= problem_.widths[width_ - 1])
      width_search_->offer(*narrower_->best());
  }
  if (goOn(*width_search_, MarkerTuning::kWidthReads * problem_.effort)) return;
  const auto& found = width_search_->best();
  const bool is_same = std::abs(width - problem_.width) < 1e-9;
  width_lengths_.push_back(is_same ? length()
                           : found ? roundedUp(found->length())
                                   : std::numeric_limits<double>::quiet_NaN());
  narrower_ = std::move(width_search_);
  ++width_;
}

}  // namespace seamwise
