import {basename, dirname, extname, join} from 'node:path';

import {
  oneRepeat,
  shareApart,
  type PhotoNote,
  type PhotoReading,
  type PhotoSettings,
  type PhotoStage,
  type RepeatsMeasured,
} from '../model/print/photo-reading.js';
import {norm, type Point} from '../model/geometry/vectors.js';
import type {Print} from '../model/print/repeating-print.js';
import {repeatOf, type RepeatSize} from '../model/print/repeat.js';
import {isCentred} from '../model/print/wallpaper.js';
import {titleOfFile} from '../model/garment/piece-names.js';
import {failureOf, SolverError} from '../model/base/failure.js';
import {readBytes} from '../node/files.js';
import {printFromPixels, type PrintFromPixels} from '../node/index.js';
import {pictureIn, pictureLimit, pngOf} from '../node/picture-files.js';
import {parseArguments, UsageError, type Arguments} from './base/arguments.js';
import {checkDistinct, checkWritable, writeWhole} from './base/files.js';
import {print, remark, StatusLine} from './base/terminal.js';

const grammar = {
  files: ['the picture'],
  valued: ['--f35', '--measure', '--between', '--out'],
  repeated: ['--measure'],
  switches: ['--tile', '--symmetrise', '--json'],
};

/** `photo`: reads a print from a photo or scan of its fabric. */
export async function photo(words: readonly string[]): Promise<void> {
  const args = parseArguments(words, grammar);
  const [path = ''] = args.files;
  const settings = settingsOf(args);
  const outFile = args.value('--out');
  const tileFile = outFile === undefined ? undefined : tileBeside(outFile);
  checkDistinct({'--out': outFile, 'its picture': tileFile});
  for (const file of [outFile, tileFile]) {
    if (file !== undefined) await checkWritable(file, [path]);
  }
  const {pixels, f35} = await pictureIn(await readBytes(path, pictureLimit), path);
  const known = {...(f35 !== undefined && {f35}), ...settings};
  const found = await timed(path, known, () => read(pixels, known, args.has('--symmetrise')));
  if (outFile !== undefined && tileFile !== undefined) {
    await writeWhole(tileFile, await pngOf(found.tile));
    await writeWhole(outFile, printText(found.print, path, tileFile));
  }
  report(path, found.reading, known, args.has('--json'));
}

const status = new StatusLine();

const stages: Readonly<Record<PhotoStage, string>> = {
  repeat: 'Looking for the repeat',
  light: 'Evening out the light',
  symmetry: 'Comparing symmetries',
  tile: 'Making the cell',
  object: 'Looking for the outline',
};

const read = (
  pixels: Parameters<typeof printFromPixels>[0],
  settings: PhotoSettings,
  symmetrise: boolean,
): Promise<PrintFromPixels> =>
  printFromPixels(
    pixels,
    {...settings, symmetrise},
    {
      onProgress: ({stage, fraction}) => {
        status.write(`${stages[stage]}, ${Math.floor(100 * fraction)} %`);
      },
    },
  );

/** Runs the work, and adds the file and a hint to its errors. */
async function timed(
  path: string,
  {isTile = false}: PhotoSettings,
  work: () => Promise<PrintFromPixels>,
): Promise<PrintFromPixels> {
  try {
    return await work();
  } catch (error) {
    if (!(error instanceof SolverError) || error.code === 'internal') throw error;
    const mayBeTile = !isTile && (error.reason === 'noRepeat' || error.reason === 'fewRepeats');
    const hint = mayBeTile ? ' If it is one seamless tile, say --tile.' : '';
    throw new SolverError({...failureOf(error), message: `${path}: ${error.message}${hint}`});
  } finally {
    status.clear();
  }
}

const numberIn = (text: string | undefined): number =>
  text === undefined || text.trim() === '' ? NaN : Number(text);

const isLength = (cm: number): boolean => cm >= 0.1 && cm <= 10_000;

/** @throws {UsageError} for an invalid value */
function settingsOf(args: Arguments): PhotoSettings {
  const f35 = args.value('--f35');
  if (f35 !== undefined && !(numberIn(f35) >= 5 && numberIn(f35) <= 2000)) {
    throw new UsageError(`--f35 is '${f35}', but must be a focal length from 5 to 2000 mm.`);
  }
  const measured = new Map(args.values('--measure').map(measureOf));
  if (measured.size < args.values('--measure').length) {
    throw new UsageError('--measure gives one vector twice; give w1 and w2 once each.');
  }
  const [w1, w2] = [measured.get('w1'), measured.get('w2')];
  const between = args.value('--between');
  return {
    ...(f35 !== undefined && {f35: numberIn(f35)}),
    ...(w1 && {w1Measured: w1}),
    ...(w2 && {w2Measured: w2}),
    ...(between !== undefined && {between: betweenOf(between)}),
    ...(args.has('--tile') && {isTile: true}),
  };
}

/**
 * Parses a measurement such as `w1=10/98.5`.
 * @throws {UsageError} if it is invalid
 */
function measureOf(text: string): readonly [string, RepeatsMeasured] {
  const [, vector, count, length] = /^(w[12])=([^/]+)\/(.+)$/.exec(text) ?? [];
  const measured = {repeats: numberIn(count), cm: numberIn(length)};
  const {repeats, cm} = measured;
  if (vector === undefined || !(repeats > 0 && repeats <= 10_000) || !isLength(cm)) {
    throw new UsageError(
      `--measure is '${text}', but must be w1 or w2 = repeats / cm, as in w1=10/98.5.`,
    );
  }
  return [vector, measured];
}

/**
 * Parses a distance such as `120,80,1020,95=30`.
 * @throws {UsageError} if it is invalid
 */
function betweenOf(text: string): NonNullable<PhotoSettings['between']> {
  const [points = '', length] = text.split('=');
  const [x1 = NaN, y1 = NaN, x2 = NaN, y2 = NaN, ...rest] = points.split(',').map(numberIn);
  const cm = numberIn(length);
  const apart = Math.hypot(x2 - x1, y2 - y1);
  if (rest.length > 0 || !isLength(cm) || !(apart >= 1 && Number.isFinite(apart))) {
    throw new UsageError(
      `--between is '${text}', but must be two points in pixels and their distance in cm, as in 120,80,1020,95=30.`,
    );
  }
  return {from: [x1, y1], to: [x2, y2], cm};
}

/**
 * The path of the tile beside the print file.
 * @throws {UsageError} if that is no JSON file
 */
function tileBeside(outFile: string): string {
  if (extname(outFile).toLowerCase() !== '.json') {
    throw new UsageError(`${outFile} would hold JSON; name a file ending in .json.`);
  }
  return join(dirname(outFile), `${basename(outFile, extname(outFile))}.png`);
}

/** The print file, with the photo's name as its title. */
function printText(found: Print, path: string, tileFile: string): string {
  const title = titleOfFile(basename(path, extname(path)));
  return `${JSON.stringify({...found, title, image: basename(tileFile)}, null, 2)}\n`;
}

function report(
  path: string,
  reading: PhotoReading,
  settings: PhotoSettings,
  isJson: boolean,
): void {
  if (isJson) {
    print(JSON.stringify(plainReading(reading)));
    return;
  }
  const {group, copies, confidence, notes, stripes} = reading;
  const size = sizeOf(reading);
  const said = size
    ? sizeWords(reading, size)
    : 'size unknown (measure it: --measure w1=REPEATS/CM)';
  const seen = stripes ? '' : `, ${copies} copies`;
  print(`${path}: ${group}, ${said}, ${lying(reading)}${seen}, ${confidence}`);
  const apart = conflict(reading, settings);
  if (apart !== undefined) remark(apart);
  if (confidence === 'uncertain')
    remark('No repeat is certain: compare the tile with your fabric before you use it.');
  notes.forEach((note) => {
    remark(sentences[note]);
  });
}

const sentences: Readonly<Record<PhotoNote, string>> = {
  uneven: 'The fabric does not lie quite flat; smooth it out and take another for an exact size.',
  differs: 'Parts of the picture differ from all other copies of the print; they are left out.',
  focalLength:
    'The camera is unknown, so that height against width is known to a few per cent only; measure both w1 and w2.',
  unequal:
    'w1 and w2 measure differently, so that a smaller symmetry was taken than the print seems to have; measure again if they should be equal.',
};

/**
 * The size of one repeat as shown on the page. Its sides differ from w1 and w2 on rhombic and
 * hexagonal lattices.
 */
const sizeOf = ({group, w1, w2}: PhotoReading): RepeatSize | null =>
  w1 && w2 ? repeatOf({group, w1, w2}).size : null;

function sizeWords(
  {group, w1, w2, latticeUncertainty, stripes}: PhotoReading,
  {width, height}: RepeatSize,
): string {
  if (stripes) return `stripes, one repeat ${width.toFixed(2)} cm`;
  const [across, up, first, second] = [width, height, norm(w1 ?? [0, 0]), norm(w2 ?? [0, 0])].map(
    (length) => length.toFixed(2),
  );
  const vectors = isCentred(group) ? `, w1 ${first} and w2 ${second} cm` : '';
  const error = (100 * latticeUncertainty).toFixed(2);
  return `one repeat ${across} x ${up} cm${vectors} (+-${error} %)`;
}

/** The direction of a vector in the photo, y down. */
function directionOf([x, y]: Point): string {
  const eighth = (Math.round((4 * Math.atan2(y, x)) / Math.PI) + 8) % 8;
  const words = ['to the right', 'down to the right', 'down', 'down to the left'];
  const others = ['to the left', 'up to the left', 'up', 'up to the right'];
  return [...words, ...others][eighth] ?? '';
}

/** The directions of w1 and w2, for measuring them. */
const lying = ({w1Px, w2Px, stripes}: PhotoReading): string =>
  stripes
    ? `w1 ${directionOf(w1Px)} across them`
    : `w1 ${directionOf(w1Px)} and w2 ${directionOf(w2Px)} on the picture`;

/** A warning if two measured lengths contradict the photo. */
function conflict(
  {seen, stripes}: PhotoReading,
  {w1Measured, w2Measured}: PhotoSettings,
): string | undefined {
  const [w1, w2] = [oneRepeat(w1Measured), oneRepeat(w2Measured)];
  if (w1 === undefined || w2 === undefined || stripes) return undefined;
  const share = shareApart(w1, w2, seen.aspect);
  if (share <= seen.error) return undefined;
  const [first, second, expected] = [w1, w2, w1 * seen.aspect].map((cm) => cm.toFixed(2));
  return `The lengths disagree by ${(100 * share).toFixed(0)} %: with ${first} cm along w1, the picture shows ${expected} cm along w2, not ${second} cm. Both were taken; measure again.`;
}

/** The reading as JSON data. */
function plainReading(reading: PhotoReading): object {
  const {map, groups} = reading;
  const {width, height, w1Px, w2Px, originPx, w1, w2, group, confidence} = reading;
  const {latticeUncertainty, oneWay, stripes, copies, explained, notes} = reading;
  return {
    ...{width, height, homography: map.homography, lens: map.lens, w1Px, w2Px, originPx, w1, w2},
    size: sizeOf(reading),
    ...{group, groups: groups.map(({name, rho, worst, verdict}) => ({name, rho, worst, verdict}))},
    ...{confidence, latticeUncertainty, oneWay, stripes, copies, explained, notes},
  };
}
