#pragma once
#include <optional>
#include <string>

#include "wallpaper/group.h"

namespace seamwise {

/// A repeating print: its group, lattice and how it may lie on the cloth. +y is the warp.
struct Print {
  WallpaperGroup group;
  bool one_way =
      false;  ///< the print has an upside: a piece on grain may not be turned by 180 degrees
};

}  // namespace seamwise
