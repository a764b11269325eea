/** The dialect of a DXF file that is written, and its unit. */

/** Dialects: ANSI/AAMA-292 and ASTM D6673. */
export const dxfStyles = ['aama', 'astm'] as const;

export type DxfStyle = (typeof dxfStyles)[number];

/** Units, which files name METRIC and ENGLISH. */
export const dxfUnits = ['mm', 'in'] as const;

export type DxfUnit = (typeof dxfUnits)[number];

export interface DxfFormat {
  /** `astm` adds validation copies of all lines on layers 85 to 87. Default aama. */
  readonly style?: DxfStyle;
  /** Default mm. */
  readonly unit?: DxfUnit;
}
