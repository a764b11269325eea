#include "photo/tile/tile_reading.h"

#include <algorithm>
#include <string>

#include "base/decimal.h"
#include "tuning/tile_reading.h"

namespace seamwise {
namespace {

Mat2 squarePixels(const SeamlessTile& tile) {
  const double width = tile.width(), height = tile.height();
  return Vec2(width * width, height * height).asDiagonal();
}

Error openEdge(bool sides, double at) {
  const std::string which = sides ? "left and right" : "top and bottom";
  const std::string where =
      decimal(std::lround(100 * at)) + (sides ? " % of the way down" : " % of the way across");
  return {Failure::kPicture,
          "the picture's edges do not meet: " + which + " differ here (" + where +
              "): give the whole repeat, or a photo that shows several",
          -1, -1, "edges"};
}

Error missingLine(bool sides) {
  const std::string which = sides ? "left and right" : "top and bottom";
  const std::string line = sides ? "column" : "row";
  return {Failure::kPicture,
          "the picture's edges do not meet: " + which + " differ here, as though one " + line +
              " of pixels were cut away: give the whole repeat, or a photo that shows several",
          -1, -1, "edges"};
}

}  // namespace

bool TileReader::advance() {
  switch (stage_) {
    case Stage::kEdges:
      compareEdges();
      break;
    case Stage::kCell:
      if (!found_->advance()) stage_ = Stage::kTrials;
      break;
    case Stage::kTrials:
      tryNext();
      break;
    case Stage::kDone:
      break;
  }
  return stage_ != Stage::kDone;
}

bool TileReader::readsGroups() const {
  return stage_ > Stage::kCell || (stage_ == Stage::kCell && found_->readsGroups());
}

double TileReader::fraction() const {
  const double edges = compared_ + (comparison_ ? comparison_->fraction() : 0);
  const double edges_done = edges / (any_edges_ ? 4 : 2);
  const double read = stage_ < Stage::kTrials ? 0 : 1 + trial_;
  return TileReadingTuning::kEdgesShare * edges_done +
         (1 - TileReadingTuning::kEdgesShare) * read / (1 + Trial::kTrials);
}

void TileReader::fail(const Error& error) {
  error_ = error;
  stage_ = Stage::kDone;
}

void TileReader::compareEdges() {
  if (std::min(tile_.width, tile_.height) < TileReadingTuning::kLeastPixels) {
    return fail({Failure::kPicture,
                 "the picture has only " + decimal(tile_.width) + " x " + decimal(tile_.height) +
                     " pixels: give one of at least " + decimal(TileReadingTuning::kLeastPixels) +
                     " each way",
                 -1, -1, "small"});
  }
  const bool across = compared_ % 2 == 0;
  if (!comparison_) {
    comparison_ = std::make_unique<EdgeComparison>(
        tile_, across ? TileSides::kLeftAndRight : TileSides::kTopAndBottom,
        compared_ < 2 ? NextCopy::kBeside : NextCopy::kHalfAside);
  }
  if (comparison_->advance()) return;
  TileEdge* const edges[] = {&seams_.across, &seams_.up, &seams_.half_drop, &seams_.brick};
  const TileEdge& edge = *edges[compared_++] = comparison_->edge();
  comparison_.reset();
  if (any_edges_ && compared_ < 4) return;
  if (!any_edges_ && !edge.meets) return fail(openEdge(across, edge.differs_at));
  if (compared_ < 2) return;
  found_ = std::make_unique<SeamlessReader>(SeamlessTile{tile_}, squarePixels({tile_}));
  stage_ = Stage::kCell;
}

void TileReader::tryNext() {
  if (other_) {
    if (other_->advance()) return;
    judge(trial_++);
    other_.reset();
    return;
  }
  while (trial_ < Trial::kTrials && !isWorthTrying(trial_)) ++trial_;
  if (trial_ < Trial::kTrials)
    begin(trial_);
  else
    stage_ = Stage::kDone;
}

bool TileReader::isWorthTrying(int trial) const {
  if (trial < Trial::kOneMoreColumn) return tile_.width == tile_.height;
  if (trial == Trial::kOneMoreRow && seams_.missing_column) return false;
  return square_pixels_ && !reading().groups.stripes && seams_.across.meets && seams_.up.meets;
}

void TileReader::begin(int trial) {
  SeamlessTile tile{tile_};
  if (trial == Trial::kOneMoreColumn) tile.more_columns = 1;
  if (trial == Trial::kOneMoreRow) tile.more_rows = 1;
  Mat2 sides = squarePixels(tile);
  if (trial < Trial::kOneMoreColumn)
    sides(0, 1) = sides(1, 0) = (trial == Trial::kSharpHexagon ? 0.5 : -0.5) * sides(0, 0);
  other_ = std::make_unique<SeamlessReader>(tile, sides);
}

void TileReader::judge(int trial) {
  if (trial < Trial::kOneMoreColumn) {
    if (!other_->isHexagonal() || other_->symmetries() <= found_->symmetries()) return;
    found_ = std::move(other_);
    square_pixels_ = false;
    return;
  }
  if (!found_->isMendedBy(*other_)) return;
  const bool is_column = trial == Trial::kOneMoreColumn;
  (is_column ? seams_.missing_column : seams_.missing_row) = true;
  if (!any_edges_) fail(missingLine(is_column));
}

}  // namespace seamwise
