#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "bindings/values.h"
#include "photo/base/picture.h"

namespace seamwise {

/// JavaScript handle of a step-by-step task on a photo. Every call after a failure is harmless and
/// does nothing. All tasks share one interface: each class and signature at the boundary takes 0.3
/// kB of a module, compressed.
class PictureWork {
 public:
  /// @param request   see photo.d.mts; all its numbers are finite except those that may be NaN
  explicit PictureWork(const val& request);
  virtual ~PictureWork() = default;
  PictureWork(const PictureWork&) = delete;  // its parts refer to each other
  PictureWork& operator=(const PictureWork&) = delete;

  val failure() const { return failureValue(error_); }
  virtual bool advance() = 0;
  virtual val stage() const = 0;
  virtual double fraction() const = 0;
  /// The result, once the task is done.
  virtual val answer() const = 0;

 protected:
  /// Fails unless the image has a size that its bytes fill and `others_hold`, the other conditions,
  /// is true.
  bool check(bool others_hold = true);
  void fail(const std::optional<Error>& error) { error_ = error; }
  bool failed() const { return error_.has_value(); }
  const PixelView& view() const { return view_; }

 private:
  std::vector<std::uint8_t> bytes_;
  PixelView view_;
  std::optional<Error> error_;
};

/// Reads the print from a photo.
PictureWork* photoWork(const val& request);
/// Makes an image of the print's cell.
PictureWork* photoTileWork(const val& request);
/// Finds the outline of an object of known size.
PictureWork* photoObjectWork(const val& request);

}  // namespace seamwise
