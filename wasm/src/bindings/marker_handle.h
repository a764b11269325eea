#pragma once
#include <memory>
#include <optional>
#include <string>

#include "bindings/values.h"
#include "nesting/marker.h"

namespace seamwise {

/// A layout as JavaScript holds it. After a failure every call is harmless and does nothing. Lists
/// of points are flat; lengths are in cm.
class MarkerHandle {
 public:
  /// @param request   as marker.d.mts describes it, all its numbers finite
  explicit MarkerHandle(const val& request);

  val failure() const { return failureValue(error_); }
  /// Goes on until about so many million table reads are spent. False when nothing is left to do.
  bool advance(double work);
  std::string stage() const;
  double fraction() const { return marker_ ? marker_->fraction() : 0; }
  int count() const { return marker_ ? marker_->count() : 0; }
  /// Once there is one: the best layout so far.
  val layout() const;
  val report() const;

 private:
  std::unique_ptr<Marker> marker_;
  std::optional<Error> error_;
};

}  // namespace seamwise
