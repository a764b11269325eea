#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "bindings/values.h"
#include "recognition/base/picture.h"

namespace seamwise {

/// What goes on with a picture step by step, as JavaScript holds it. After a failure every call is
/// harmless and does nothing. One face for all of it: each class and signature that crosses takes
/// 0.3 kB of a module, compressed.
class PictureWork {
 public:
  /// @param request   as photo.d.mts describes it, all its numbers finite but those that may be NaN
  explicit PictureWork(const val& request);
  virtual ~PictureWork() = default;
  PictureWork(const PictureWork&) = delete;  // its parts refer to each other
  PictureWork& operator=(const PictureWork&) = delete;

  val failure() const { return failureValue(error_); }
  virtual bool advance() = 0;
  virtual val stage() const = 0;
  virtual double fraction() const = 0;
  /// Once done.
  virtual val answer() const = 0;

 protected:
  /// Fails unless the picture has a size that its bytes fill, and what else is asked holds.
  bool check(bool others_hold = true);
  void fail(const std::optional<Error>& error) { error_ = error; }
  bool failed() const { return error_.has_value(); }
  const PixelView& view() const { return view_; }

 private:
  std::vector<std::uint8_t> bytes_;
  PixelView view_;
  std::optional<Error> error_;
};

/// Reads a print off a picture.
PictureWork* photoWork(const val& request);
/// Makes an image of its cell.
PictureWork* photoTileWork(const val& request);
/// Looks for the outline of a thing of known size.
PictureWork* photoObjectWork(const val& request);

}  // namespace seamwise
