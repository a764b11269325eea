#pragma once
#include <array>

namespace seamwise {

/// Mechanical properties of a fabric, all in SI: sheet stiffnesses in N/m, bending stiffnesses in N
/// m.
struct Fabric {
  const char* name;
  double density;     ///< kg/m2
  double warp, weft;  ///< N/m: force per width over strain, along and across the grain
  double coupling;    ///< N/m: tension across per strain along; less than sqrt(warp weft)
  double shear;       ///< N/m
  double stiff_from;  ///< strain at which the threads are straight
  double stiffening;  ///< factor on the warp and weft stiffness beyond that strain
  double bending_warp, bending_weft;  ///< N m, for bending the warp and the weft
  double friction;                    ///< coefficient, on the linen cover of a form
  double offset;                      ///< m, from the form to the middle of the cloth
};

// The stiffness of cloth rises by an order of magnitude within the first tenth of strain. Two
// linear pieces approximate the measured curves of H. Wang, J. O'Brien, R. Ramamoorthi,
// "Data-Driven Elastic Models for Cloth", SIGGRAPH 2011 (table of materials; "Wang" below is this
// paper). Friction, offsets and the values marked as chosen below are our choices.

/// Cotton poplin of shirts and summer dresses. Wang, white dots on black: 128 g/m2, 2000-2170 N/m,
/// shear 17-100, bending 10-66e-6. Bending follows KES measurements of shirtings, about 0.07 gf
/// cm2/cm = 7e-6 N m. Shear is chosen at the upper end, where the drape of poplin is closest to
/// measured cotton. Coupling: Poisson's ratio 0.24 of plain cotton, 150 g/m2 (Penava et al. 2014).
inline constexpr Fabric kPoplin{"poplin", 0.12, 2000, 1800, 450, 100,
                                0.03,     4,    9e-6, 7e-6, 0.4, 0.0015};

/// Single jersey. Wang, gray interlock: 187 g/m2, 34-414 N/m along the wales, 17-140 along the
/// courses, bending 7-39e-6. Coupling is chosen, and so is the strain of 15 % at which the loops
/// are straight.
inline constexpr Fabric kJersey{"jersey", 0.17, 130, 50, 20, 35, 0.15, 8, 5e-6, 4e-6, 0.5, 0.0012};

/// Denim of 11 oz. Wang, 11oz black denim: 324 g/m2, 1014-1060 and 205-232 N/m, shear 53-84,
/// bending 60-120e-6. Coupling is chosen.
inline constexpr Fabric kDenim{"denim", 0.32, 1050, 220, 70, 70, 0.03, 4, 80e-6, 60e-6, 0.5, 0.002};

/// Silk or polyester chiffon. The density is a trade value. The bending stiffness makes a disc
/// drape as silks do, drape coefficient 20-40 (Matsudaira 2003). All other stiffnesses are chosen.
inline constexpr Fabric kChiffon{"chiffon", 0.05, 900,    700,    160, 15,
                                 0.03,      4,    0.8e-6, 0.6e-6, 0.3, 0.001};

inline constexpr std::array<Fabric, 4> kFabrics{kPoplin, kJersey, kDenim, kChiffon};

inline constexpr double kGravity = 9.81;  ///< m/s2

}  // namespace seamwise
