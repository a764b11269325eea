#pragma once
#include <vector>

#include "symmetry/registration.h"

namespace seamwise {

/// Where a search for a mirror map begins.
struct MirrorStart {
  RigidMotion map;
  double rms;  ///< distance of corresponding points, as root mean square. [cm]
};

/// Looks for all mirror maps of a onto b within kMirrorTolerance (a rectangle has two onto itself),
/// in steps. The starts are all cyclic shifts of the arc-length correspondence, each solved in
/// closed form. Both outlines outlive the search.
class MirrorSearch {
 public:
  MirrorSearch(const Outline& a, const Outline& b);

  /// Refines one start: some milliseconds where outlines have thousands of corners. False when none
  /// was left.
  bool advance();
  /// Once it has ended: all that were found, best first.
  std::vector<MirrorRegistration> take();

 private:
  const Outline *a_, *b_;
  std::vector<MirrorStart> starts_;  ///< without those that lie too far off
  std::size_t next_ = 0;
  std::vector<MirrorRegistration> found_;
};

/// All mirror maps of a onto b that a MirrorSearch finds, the least residual first.
std::vector<MirrorRegistration> findMirrors(const Outline& a, const Outline& b);

/// The best mirror map of a onto b, however bad it is.
MirrorRegistration bestMirror(const Outline& a, const Outline& b);

}  // namespace seamwise
