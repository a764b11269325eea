#pragma once
#include <vector>

#include "alignment/search/search.h"
#include "seam/join.h"

namespace seamwise {

enum class Phase : std::uint8_t { kAlignment = 0, kDeformation = 1, kDone = 2 };

/// One method at work on a meshed pattern, in small steps.
class Run {
 public:
  virtual ~Run() = default;
  /// A few milliseconds of work. False when the method has ended.
  virtual bool advance() = 0;
  virtual Phase phase() const = 0;
  virtual double fraction() const = 0;              ///< 0..1, monotone
  virtual const Alignments& alignment() const = 0;  ///< of the pieces; the best so far
  virtual const Alignments& search() const = 0;     ///< where the alignment search ended
  /// Once it has ended: the best few that the searches have compared, of all pieces.
  virtual std::vector<Alignments> compared() const { return {}; }
  /// No alignment at rest costs less than this share of search(): 1 when it is proven the best, 0
  /// when nothing is known.
  virtual double searchBound() const { return 0; }
  /// What the pieces as drafted cost at search(), by the seams' weights. [cm2]
  virtual double searchCost() const { return 0; }
  virtual const Shapes& shapes() const = 0;
  virtual int iterations() const = 0;
  virtual int factorisations() const = 0;
  /// The search at work, to lend shares of it; null when there is none.
  virtual AlignmentSearch* searching() { return nullptr; }
  /// Grows when the deformation starts over with other weights; only the last attempt's time
  /// counts.
  virtual int attempt() const { return 0; }
};

}  // namespace seamwise
