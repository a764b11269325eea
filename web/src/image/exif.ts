/** Reads metadata of cameras and programs in JPEG files. */

export interface ExifTags {
  /** EXIF orientation of the stored image, 1 to 8; 1 is upright. */
  readonly orientation?: number;
  /** Focal length equivalent to 35 mm film. */
  readonly f35?: number;
  /** Pixels per unit, across and down. Unit 2 is the inch, 3 the cm. */
  readonly resolution?: readonly [number, number];
  readonly resolutionUnit?: number;
}

/** Segments of a JPEG file before its pixels, and their offsets. */
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

/**
 * EXIF tags of a JPEG file; empty without any.
 * @throws {RangeError} if the file ends too early
 */
export function exifTags(view: DataView): ExifTags {
  for (const {marker, at} of jpegSegments(view)) {
    const isExif = marker === 0xffe1 && view.getUint32(at + 4) === 0x45786966;
    if (isExif) return tagsFrom(view, at + 10);
  }
  return {};
}

/** Tags of the TIFF structure at offset `start`. */
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
