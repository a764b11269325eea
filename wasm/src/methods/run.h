#pragma once
#include <vector>

#include "alignment/search/search.h"
#include "seam/join.h"

namespace seamwise {

enum class Phase : std::uint8_t { kAlignment = 0, kDeformation = 1, kDone = 2 };

/// A method that runs in small steps on a meshed pattern.
class Run {
 public:
  virtual ~Run() = default;
  /// Works for a few milliseconds. Returns false when the method has ended.
  virtual bool advance() = 0;
  virtual Phase phase() const = 0;
  virtual double fraction() const = 0;              ///< 0..1, monotone
  virtual const Alignments& alignment() const = 0;  ///< the best so far, of all pieces
  virtual const Alignments& search() const = 0;  ///< result of the alignment search, of all pieces
  /// The best few answers that the searches have compared, of all pieces, once the run has ended.
  virtual std::vector<Alignments> compared() const { return {}; }
  /// No alignment at rest costs less than this share of search(): 1 when it is proven the best, 0
  /// when nothing is known.
  virtual double searchBound() const { return 0; }
  /// Cost of the drafted pieces at search(), by the seams' weights. [cm2]
  virtual double searchCost() const { return 0; }
  virtual const Shapes& shapes() const = 0;
  virtual int iterations() const = 0;
  virtual int factorisations() const = 0;
  /// The current search, to lend shares of it; null when there is none.
  virtual AlignmentSearch* searching() { return nullptr; }
  /// Grows when the deformation restarts with other weights; only the last attempt's time counts.
  virtual int attempt() const { return 0; }
};

}  // namespace seamwise
