/** What cameras and programs write into JPEG files beside the pixels. */

export interface ExifTags {
  /** How the stored picture has to be turned or mirrored to stand upright: 1 to 8, 1 is as it is. */
  readonly orientation?: number;
  /** Focal length, as on film of 36 mm. */
  readonly f35?: number;
  /** Pixels per unit, across and down; 2 stands for inches, 3 for cm. */
  readonly resolution?: readonly [number, number];
  readonly resolutionUnit?: number;
}

/** Parts of a JPEG file before its pixels, and where each begins. */
export function* jpegSegments(view: DataView): Generator<{marker: number; at: number}> {
  for (let at = 2; ;) {
    const marker = view.getUint16(at);
    if (marker === 0xffff) {
      at++; // padding
      continue;
    }
    if (marker < 0xffc0 || marker === 0xffda) return; // the pixels begin
    yield {marker, at};
    at += 2 + view.getUint16(at + 2);
  }
}

/** Of a JPEG file; none where it says nothing. @throws {RangeError} when the file ends too early */
export function exifTags(view: DataView): ExifTags {
  for (const {marker, at} of jpegSegments(view)) {
    const isExif = marker === 0xffe1 && view.getUint32(at + 4) === 0x45786966;
    if (isExif) return tagsFrom(view, at + 10);
  }
  return {};
}

/** The directories of a TIFF that lies in the file from `start` on. */
function tagsFrom(view: DataView, start: number): ExifTags {
  const little = view.getUint16(start) === 0x4949;
  const short = (at: number): number => view.getUint16(at, little);
  const long = (at: number): number => view.getUint32(at, little);
  const entries = (directory: number): ReadonlyMap<number, number> =>
    new Map(
      Array.from({length: short(directory)}, (_, k) => {
        const entry = directory + 2 + 12 * k;
        return [short(entry), entry + 8];
      }),
    );
  const rational = (at: number | undefined): number => {
    if (at === undefined) return 0;
    const place = start + long(at);
    return long(place) / long(place + 4);
  };
  const first = entries(start + long(start + 4));
  const camera = first.get(0x8769);
  const f35At = camera === undefined ? undefined : entries(start + long(camera)).get(0xa405);
  const [orientationAt, unitAt] = [first.get(0x0112), first.get(0x0128)];
  return {
    resolution: [rational(first.get(0x011a)), rational(first.get(0x011b))],
    ...(orientationAt !== undefined && {orientation: short(orientationAt)}),
    ...(unitAt !== undefined && {resolutionUnit: short(unitAt)}),
    ...(f35At !== undefined && short(f35At) > 0 && {f35: short(f35At)}),
  };
}
