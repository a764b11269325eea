#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bindings/values.h"
#include "recognition/photo/photo.h"
#include "recognition/photo/photo_tile.h"

namespace seamwise {

/// A print that is read off a picture, as JavaScript holds it. After a failure every call is
/// harmless and does nothing.
class PhotoHandle {
 public:
  /// @param request   as photo.d.mts describes it, all its numbers finite but those that may be NaN
  explicit PhotoHandle(const val& request);

  val failure() const { return failureValue(error_); }
  bool advance();
  val stage() const;
  double fraction() const { return photo_ ? photo_->fraction() : 0; }
  val report() const;

 private:
  std::vector<std::uint8_t> bytes_;
  std::unique_ptr<Photo> photo_;
  std::optional<Error> error_;
};

/// The image of a print's cell that is made of a picture, as JavaScript holds it.
class PhotoTileHandle {
 public:
  explicit PhotoTileHandle(const val& request);

  val failure() const { return failureValue(error_); }
  bool advance() { return tile_ && tile_->advance(); }
  double fraction() const { return tile_ ? tile_->fraction() : 0; }
  val tile() const;

 private:
  std::vector<std::uint8_t> bytes_;
  std::unique_ptr<PhotoTile> tile_;
  std::optional<Error> error_;
};

/// The outline of a thing of known size on a picture, as photo.d.mts describes request and answer.
val knownObjectIn(const val& request);

}  // namespace seamwise
