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

/// JavaScript handle of a drape, which reads and hangs its garment before it drapes it. Every call
/// after a failure is harmless and does nothing. Lists of points are flat. Lengths are in cm for
/// data of the result file, and in SI units for data of fabrics.
class DrapeHandle {
 public:
  /// @param request   result and body: documents, the latter may be empty; their names; fabric,
  ///                  size: names, the latter may be empty; effort;
  ///                  settled: final positions of an earlier drape, or none
  explicit DrapeHandle(const val& request);

  val failure() const { return failureValue(error_); }
  /// Works until about `work` is spent; the first call reads, meshes and hangs. Returns false when
  /// nothing remains to be done.
  bool advance(double work);
  std::string stage() const;
  double fraction() const { return worn_ ? worn_->drape().fraction() : 0; }

  /// The form, available once the garment hangs.
  val form() const;
  /// The simulated mesh, which changes when `stage` becomes "settle".
  val mesh() const;
  /// Positions of the mesh vertices, in single and in double precision. [cm]
  val shown() const;
  val positions() const;
  /// Fabric, stages, check and notes, once the drape is done.
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
  std::string name_;  ///< name of the result's file
  std::unique_ptr<WornGarment> worn_;
  std::optional<Error> error_;
  std::ptrdiff_t stitches_ = 0;  ///< number of seams in the file; later ones close bands
  std::vector<int> place_;       ///< index in the worn garment, per piece of the file
};

}  // namespace seamwise
