#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bindings/values.h"
#include "drape/form_mesh.h"
#include "io/solved_json.h"

namespace seamwise {

/// A drape as JavaScript holds it: first its garment is read and hung, then it is draped. After a
/// failure every call is harmless and does nothing. Lists of points are flat; lengths are in cm
/// where the result file has them, SI where fabrics do.
class DrapeHandle {
 public:
  /// @param request   result and body: documents, the latter may be empty; their names; fabric,
  ///                  size: names, the latter may be empty; effort;
  ///                  settled: positions that an earlier drape ended with, or none
  explicit DrapeHandle(const val& request);

  val failure() const { return failureValue(error_); }
  /// Goes on until about so much work is spent; the first call reads, meshes and hangs. False when
  /// there is nothing left to do.
  bool advance(double work);
  std::string stage() const;
  double fraction() const { return worn_ ? worn_->drape().fraction() : 0; }

  /// Once it hangs: the form.
  val form() const;
  /// The mesh that moves; changes when `stage` becomes "settle".
  val mesh() const;
  /// Of the cloth's vertices, in single and in double precision. [cm]
  val shown() const;
  val positions() const;
  /// Once it is done: fabric, stages, check, notes.
  val report() const;

 private:
  void hang();
  const SewnLevel& level() const { return worn_->drape().level(); }
  val piece(int index) const;

  struct Request {
    std::string result, result_name, body, body_name, fabric, size;
    double effort;
    std::vector<double> settled;
  };
  Request request_;
  std::string name_;  ///< of the result's file
  std::unique_ptr<WornGarment> worn_;
  std::optional<Error> error_;
  std::ptrdiff_t stitches_ = 0;  ///< seams of the file; those after them close bands
  std::vector<int> place_;       ///< per piece of the file: which of the worn garment's it is
};

}  // namespace seamwise
