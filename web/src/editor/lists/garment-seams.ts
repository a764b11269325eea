/** What a garment file says about its seams that a result does not repeat. */

export interface GarmentSeam {
  readonly stitch: number;
  /** What people call it. */
  readonly name?: string;
  readonly weight?: number;
  readonly matched?: boolean;
}

/** By the number of the seam. The solver has checked the file; plain GarmentCode says nothing. */
export function garmentSeams(text: string): ReadonlyMap<number, GarmentSeam> {
  const {seams = []} = JSON.parse(text) as {readonly seams?: readonly GarmentSeam[]};
  return new Map(seams.map((seam) => [seam.stitch, seam]));
}
