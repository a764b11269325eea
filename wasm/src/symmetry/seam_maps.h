#pragma once
#include <array>
#include <optional>
#include <vector>

#include "symmetry/mirror_search.h"
#include "symmetry/outline.h"
#include "symmetry/placement.h"

namespace seamwise {

/// The image of a point on a sewn edge.
struct Probe {
  Vec2 image = Vec2::Zero();  ///< point on the outline of the target piece
  int sewn_piece = -1;        ///< piece that is sewn to the image; -1: none
  Vec2 sewn = Vec2::Zero();   ///< the corresponding point of that piece
};

/// A mirror map of a piece onto a piece, with the images of probe points on its edges.
struct PieceMap {
  static constexpr int kProbes = 4;  ///< probes at 1/8, 3/8, 5/8, 7/8 of the arc length

  int from = -1, to = -1;
  int inverse = -1;  ///< index of the inverse map; its own for a reflection
  MirrorRegistration registration;
  double disagreement = 0;  ///< deviation from the 3D placement, then from the grain. [cm]
  std::vector<std::array<Probe, kProbes>> probes;  ///< per edge of `from`
};

/// The map of each piece: an index into SeamMaps::maps() per piece, -1 while free.
using Assignment = std::vector<int>;

/// The part of a garment that an assignment maps onto itself.
struct Coverage {
  double seams = 0;         ///< length of the seams that map to seams. [cm]
  double outline = 0;       ///< length of the outlines that map to outlines. [cm]
  double disagreement = 0;  ///< deviation from the placement, weighted by outline. [cm2]
  int paired = 0;           ///< pieces whose image is another piece

  Coverage operator+(const Coverage& other) const;
  /// Compares by more seams, then more outline (either by more than one per cent), then closer
  /// placement, then fewer pairs.
  bool betterThan(const Coverage& other) const;
};

/// All mirror maps between the pieces of a garment, and the images of its seams. The maps are
/// computed in steps. The garment must outlive this object.
class SeamMaps {
 public:
  explicit SeamMaps(const Garment& garment);

  /// Makes one step of the search for maps between two pieces. Returns false when all are found.
  bool advance();
  double fraction() const;  ///< share of the pairs of pieces, 0..1

  const std::vector<PieceMap>& maps() const { return maps_; }
  const std::vector<int>& mapsFrom(int piece) const { return from_[piece]; }
  const Outline& outline(int piece) const { return outlines_[piece]; }
  const Placement& placement() const { return placement_; }
  const Garment& garment() const { return garment_; }
  int pieces() const { return static_cast<int>(outlines_.size()); }

  /// Assigns a map, and every map that the seams of mapped pieces determine: if a seam's image is a
  /// seam, the neighbour across it must map to the neighbour across its image. Returns the newly
  /// mapped pieces; none if an end of `map` is assigned already.
  std::vector<int> propagate(int map, Assignment& assignment) const;
  /// Coverage that the given newly mapped pieces add.
  Coverage coverage(const Assignment& assignment, const std::vector<int>& added) const;
  /// Component number per piece; pieces joined by seams have the same number.
  std::vector<int> components() const;
  bool sewn(int piece) const { return !seams_[piece].empty(); }

 private:
  struct Partner {
    EdgeRef edge;
    bool same_direction = false;
  };

  void connect();
  void addMaps(int from, int to, const std::vector<MirrorRegistration>& registrations);
  void probe(PieceMap& map) const;
  Probe probed(int piece, const OutlinePoint& image) const;
  int agreeing(const Stitch& stitch, bool swapped, const PieceMap& near, const PieceMap& far) const;
  int forced(const Stitch& stitch, bool swapped, const PieceMap& near) const;
  bool assign(int map, Assignment& assignment, std::vector<int>& added) const;

  const Garment& garment_;
  Placement placement_;
  std::vector<Outline> outlines_;
  std::vector<PieceMap> maps_;
  std::vector<std::vector<int>> from_;          ///< maps per piece
  std::vector<std::vector<int>> seams_;         ///< stitches per piece, longest first
  std::vector<std::vector<Partner>> partners_;  ///< per piece and edge; edge.piece -1 if unsewn
  std::vector<double> lengths_;                 ///< mean length of both sides per stitch
  int searched_from_ = 0, searched_to_ = 0;     ///< the pieces of the current search
  std::optional<MirrorSearch> search_;
};

}  // namespace seamwise
