#pragma once
#include <vector>

#include "symmetry/registration.h"

namespace seamwise {

/// A start of a search for a mirror map.
struct MirrorStart {
  RigidMotion map;
  double rms;  ///< root mean square distance of corresponding points. [cm]
};

/// Searches for all mirror maps of a onto b within kMirrorTolerance (a rectangle has two onto
/// itself), in steps. The starts are all cyclic shifts of the arc-length correspondence, each
/// solved in closed form. Both outlines must outlive the search.
class MirrorSearch {
 public:
  MirrorSearch(const Outline& a, const Outline& b);

  /// Refines one start, which takes some milliseconds for outlines with thousands of corners.
  /// Returns false if none was left.
  bool advance();
  /// Returns all maps found, best first; requires that advance() has returned false.
  std::vector<MirrorRegistration> take();

 private:
  const Outline *a_, *b_;
  std::vector<MirrorStart> starts_;  ///< starts with a small enough distance
  std::size_t next_ = 0;
  std::vector<MirrorRegistration> found_;
};

/// All mirror maps of a onto b that a MirrorSearch finds, by ascending residual.
std::vector<MirrorRegistration> findMirrors(const Outline& a, const Outline& b);

/// The best mirror map of a onto b, at any residual.
MirrorRegistration bestMirror(const Outline& a, const Outline& b);

}  // namespace seamwise
