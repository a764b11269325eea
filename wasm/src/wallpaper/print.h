#pragma once
#include <optional>
#include <string>

#include "wallpaper/group.h"

namespace seamwise {

/// A repeating print: its group, its lattice and its allowed directions on the fabric. +y is the
/// warp.
struct Print {
  WallpaperGroup group;
  bool one_way =
      false;  ///< the print has an upside, so a piece on grain may not be turned by 180 degrees
};

}  // namespace seamwise
