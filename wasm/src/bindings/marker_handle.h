#pragma once
#include <memory>
#include <optional>
#include <string>

#include "bindings/values.h"
#include "marker/marker.h"

namespace seamwise {

/// JavaScript handle of a layout. Every call after a failure is harmless and does nothing. Lists of
/// points are flat; lengths are in cm.
class MarkerHandle {
 public:
  /// @param request   see marker.d.mts; all its numbers are finite
  explicit MarkerHandle(const val& request);

  val failure() const { return failureValue(error_); }
  /// Works until about `work` million table reads are spent. Returns false when nothing remains to
  /// be done.
  bool advance(double work);
  std::string stage() const;
  double fraction() const { return marker_ ? marker_->fraction() : 0; }
  int count() const { return marker_ ? marker_->count() : 0; }
  /// The best layout so far, if there is one.
  val layout() const;
  val report() const;

 private:
  std::unique_ptr<Marker> marker_;
  std::optional<Error> error_;
};

}  // namespace seamwise
