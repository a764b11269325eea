#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "pattern/garment.h"

// Garments that can be checked by hand, all lengths in cm. Pieces are drafted face up; x of the
// body points to the wearer's left, z to the front.
namespace seamwise::small {

inline Panel polygon(const std::string& name, const Polyline& corners) {
  Panel panel;
  panel.name = name;
  for (std::size_t k = 0; k < corners.size(); ++k)
    panel.edges.push_back(Curve::line(corners[k], corners[(k + 1) % corners.size()]));
  return panel;
}

inline Panel moved(Panel panel, const RigidMotion& motion) {
  for (Curve& edge : panel.edges) edge = edge.transformed(motion);
  panel.grain_angle = wrapAngle(panel.grain_angle + motion.angle);
  return panel;
}

/// x -> -x; edge 0 stays edge 0, edge k becomes edge n - k.
inline Panel mirrored(const Panel& panel, const std::string& name) {
  const RigidMotion flip{0, Vec2::Zero(), true};
  const std::size_t n = panel.edges.size();
  Panel image = panel;
  image.name = name;
  for (std::size_t k = 0; k < n; ++k)
    image.edges[(n - k) % n] = panel.edges[k].transformed(flip).reversed();
  return image;
}

inline Panel placed(Panel panel, const Vec3& shift, double turn_about_y) {
  panel.placement_shift = shift;
  panel.placement_turn = {0, turn_about_y, 0};
  return panel;
}

inline void sew(Garment& garment, const std::string& a, int edge_a, const std::string& b,
                int edge_b) {
  garment.stitches.push_back({{garment.find(a), edge_a}, {garment.find(b), edge_b}});
}

/// Edges: 0 hem, 1 right side, 2 waist, 3 left side. Symmetric across x = 0.
inline Panel skirtPanel(const std::string& name) {
  return polygon(name, {{-30, 0}, {30, 0}, {15, 50}, {-15, 50}});
}

/// A skirt; front and back have the same shape, and so have the two waistbands.
inline Garment skirt() {
  Garment g;
  const Polyline band{{-15, 0}, {15, 0}, {15, 4}, {-15, 4}};
  g.panels = {placed(skirtPanel("front"), {0, 0, 15}, 0),
              placed(skirtPanel("back"), {0, 0, -15}, kPi),
              placed(polygon("band front", band), {0, 50, 15}, 0),
              placed(polygon("band back", band), {0, 50, -15}, kPi)};
  sew(g, "front", 1, "back", 3);
  sew(g, "front", 3, "back", 1);
  sew(g, "front", 2, "band front", 0);
  sew(g, "back", 2, "band back", 0);
  sew(g, "band front", 1, "band back", 3);
  sew(g, "band front", 3, "band back", 1);
  return g;
}

/// Edges: 0 hem, 1 right side, 2 right armhole, 3 right shoulder, 4 neck, 5 - 7 the left ones.
inline Panel torso(const std::string& name, double neck_depth) {
  Panel p;
  p.name = name;
  p.edges = {Curve::line({-25, 0}, {25, 0}),
             Curve::line({25, 0}, {25, 40}),
             Curve::quadratic({25, 40}, {18, 44}, {20, 60}),
             Curve::line({20, 60}, {8, 64}),
             Curve::cubic({8, 64}, {7, 64 - neck_depth}, {-7, 64 - neck_depth}, {-8, 64}),
             Curve::line({-8, 64}, {-20, 60}),
             Curve::quadratic({-20, 60}, {-18, 44}, {-25, 40}),
             Curve::line({-25, 40}, {-25, 0})};
  return p;
}

/// Edges: 0 cuff, 1 and 4 underarm, 2 front of the cap, 3 back of the cap, `fullness` cm higher.
inline Panel sleeve(const std::string& name, double fullness) {
  Panel p;
  p.name = name;
  p.edges = {Curve::line({-10, 0}, {10, 0}), Curve::line({10, 0}, {16, 40}),
             Curve::cubic({16, 40}, {12, 42}, {8, 55}, {0, 55}),
             Curve::cubic({0, 55}, {-8, 55 + fullness}, {-12, 42 + fullness}, {-16, 40}),
             Curve::line({-16, 40}, {-10, 0})};
  return p;
}

/// Tee with set-in sleeves; with cap fullness 0 each sleeve is also symmetric in itself.
inline Garment tee(double cap_fullness) {
  Garment g;
  const Panel left = sleeve("left sleeve", cap_fullness);
  g.panels = {placed(torso("front", 9), {0, 0, 15}, 0), placed(torso("back", 2), {0, 0, -15}, kPi),
              placed(left, {45, 10, 0}, kPi / 2),
              placed(mirrored(left, "right sleeve"), {-45, 10, 0}, -kPi / 2)};
  sew(g, "front", 1, "back", 7);
  sew(g, "front", 7, "back", 1);
  sew(g, "front", 3, "back", 5);
  sew(g, "front", 5, "back", 3);
  sew(g, "front", 2, "left sleeve", 2);
  sew(g, "back", 6, "left sleeve", 3);
  sew(g, "front", 6, "right sleeve", 3);
  sew(g, "back", 2, "right sleeve", 2);
  sew(g, "left sleeve", 1, "left sleeve", 4);
  sew(g, "right sleeve", 1, "right sleeve", 4);
  return g;
}

/// Edges: 0 hem, 1 inseam, 2 crotch, 3 waist, 4 outseam.
inline Panel trouserLeg(const std::string& name, double crotch) {
  return polygon(name, {{0, 0}, {22, 0}, {28 + crotch, 75}, {24, 100}, {2, 100}});
}

/// Four legs without 3D placement. `joined`: the crotch seams are sewn too.
inline Garment trousers(bool joined) {
  Garment g;
  g.panels = {trouserLeg("front left", 0), trouserLeg("back left", 6)};
  g.panels.push_back(mirrored(g.panels[0], "front right"));
  g.panels.push_back(mirrored(g.panels[1], "back right"));
  // Edges 1 and 4 are exchanged on the right legs, and so are 2 and 3.
  for (const std::string side : {"left", "right"}) {
    sew(g, "front " + side, 1, "back " + side, 1);
    sew(g, "front " + side, 4, "back " + side, 4);
  }
  if (joined) {
    sew(g, "front left", 2, "front right", 3);
    sew(g, "back left", 2, "back right", 3);
  }
  return g;
}

}  // namespace seamwise::small
