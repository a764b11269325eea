#pragma once
#include <vector>

#include "drape/contacts.h"
#include "drape/sewn_mesh.h"

namespace seamwise {

/// Returns the ties that hold pleats of a level: layers are sewn on where a seam closes the pleat,
/// and tucks are sewn along their lines.
/// @param gap   distance between layers, m
std::vector<ClothTie> pleatTies(const SewnLevel& level, double gap);

}  // namespace seamwise
