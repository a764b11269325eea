/** The meaning of layers by their names. */
const sewn =
  /\b(?:sew(?:ing|n)?|stitch(?:ing)?|seam) ?lines?\b|nahtlinie|ligne de couture|linea di cucitura|l[ií]nea de costura/i;

const help =
  /^(?:print|match points|(?:calibration )?grid|raster|gitter|quadrillage|griglia|cuadr[ií]cula|rahmen|border|guides?)$/i;

/** The role that a layer states for its closed lines. */
export const statedRole = (layer: string): 'sewn line' | undefined =>
  sewn.test(layer) ? 'sewn line' : undefined;

/** Returns whether a layer has no lines of pieces. */
export const isHelpLayer = (layer: string): boolean => help.test(layer);
