/** Writes cases to a folder: NAME.rgba, NAME.cell.rgba, some as files too, and cases.json. */
import {existsSync, mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';

import {cellPixels, type CaseTruth, type PhotoCase} from './case.js';
import type {PhotoLevel} from './conditions.js';
import {coverCase, coverKinds} from './cover-cases.js';
import {decoyCases} from './decoy-cases.js';
import {jpegOf, pngOf, rawOf, stored, withExif, type Orientation} from './files.js';
import {allGroups} from './group-elements.js';
import {almostCase, floralCase, specialCase} from './print-cases.js';
import {specialPrints} from './special-prints.js';
import {cutTileCase, tileCase} from './tile-cases.js';

type Making = () => Promise<PhotoCase>;

type Size = readonly [number, number];
const size: Size = [960, 720];
const cameraSize: Size = [4000, 3000];

const times = <T>(count: number, of: (k: number) => T): readonly T[] =>
  Array.from({length: count}, (_, k) => of(k));

function florals(level: PhotoLevel, perGroup: number, seed: number): readonly Making[] {
  return allGroups.flatMap((group, g) =>
    times(
      perGroup,
      (k) => () =>
        floralCase(
          {name: `${level}-${group}-${k + 1}`, level, seed: seed + 100 * g + k, size},
          group,
        ),
    ),
  );
}

const specials = (level: PhotoLevel, count: number, seed: number): readonly Making[] =>
  Object.keys(specialPrints).flatMap((kind, t) =>
    times(
      count,
      (k) => () =>
        specialCase(
          {name: `${level}-${kind}-${k + 1}`, level, seed: seed + 100 * t + k, size},
          kind,
        ),
    ),
  );

const tiles = (seed: number): readonly Making[] => [
  ...allGroups.flatMap((group, g) =>
    times(2, (k) => () => tileCase(`tile-${group}-${k + 1}`, group, g + k, seed + 100 * g + k)),
  ),
  ...allGroups
    .slice(0, 6)
    .map((group, g) => () => cutTileCase(`tile-cut-${g + 1}`, group, seed + 5_000 + g)),
];

const almosts = (count: number, seed: number): readonly Making[] =>
  times(
    count,
    (k) => () =>
      almostCase({name: `normal-almost-${k + 1}`, level: 'normal', seed: seed + k, size}, k),
  );

const covered = (count: number, seed: number): readonly Making[] =>
  coverKinds.flatMap((kind, t) =>
    times(
      count,
      (k) => () =>
        coverCase({name: `covered-${kind}-${k + 1}`, seed: seed + 100 * t + k, size}, kind),
    ),
  );

const large = (seed: number): readonly Making[] =>
  (['p1', 'pmg', 'cmm', 'p4g', 'p31m'] as const).map((group, g) => () => {
    const name = `large-${group}`;
    return floralCase({name, level: 'normal', seed: seed + g, size: cameraSize}, group);
  });

/** Parts of a set, each with different seeds. */
const parts = {
  normal: (seed: number, normals: number) => florals('normal', normals, seed),
  scan: (seed: number) => florals('scan', 1, seed + 10_000),
  hard: (seed: number) => florals('hard', 2, seed + 20_000),
  special: (seed: number) => specials('normal', 2, seed + 30_000),
  decoy: (seed: number) => decoyCases(seed + 40_000, size),
  tile: (seed: number) => tiles(seed + 50_000),
  almost: (seed: number) => almosts(8, seed + 70_000),
  covered: (seed: number, normals: number) => covered(2 * normals, seed + 80_000),
  large: (seed: number) => large(seed + 60_000),
} as const;
type Part = keyof typeof parts;
const usualParts: readonly Part[] = [
  'normal',
  'scan',
  'hard',
  'special',
  'almost',
  'decoy',
  'tile',
];

/** A folder of cases; `cases.json` is written once all are there. */
class Folder {
  private readonly truths: CaseTruth[] = [];

  constructor(private readonly path: string) {
    mkdirSync(path, {recursive: true});
  }

  /**
   * Writes every fifth case, and each of more than 4 megapixels, also as a camera's file, turned
   * and tagged by one of the eight orientations; tiles as PNG; the large ones only as files.
   */
  async add({truth, pixels, cell}: PhotoCase): Promise<void> {
    const write = (ending: string, bytes: Buffer): void => {
      writeFileSync(join(this.path, `${truth.name}${ending}`), bytes);
    };
    const isLarge = pixels.width * pixels.height > 4e6;
    if (!isLarge) write('.rgba', rawOf(pixels));
    if (cell) write('.cell.rgba', rawOf(cellPixels(cell)));
    if (truth.level === 'tile') {
      write('.png', await pngOf(pixels));
    } else if (isLarge || this.truths.length % 5 === 0) {
      const orientation = (1 + (Math.ceil(this.truths.length / 5) % 8)) as Orientation;
      const jpeg = await jpegOf(stored(pixels, orientation), 95);
      write('.jpg', withExif(jpeg, orientation, truth.f35 ?? undefined));
    }
    this.truths.push(truth);
  }

  /** Keeps the list's entries for other cases. */
  list(): void {
    const file = join(this.path, 'cases.json');
    const names = new Set(this.truths.map(({name}) => name));
    const known = existsSync(file)
      ? (JSON.parse(readFileSync(file, 'utf8')) as CaseTruth[]).filter(({name}) => !names.has(name))
      : [];
    writeFileSync(file, `${JSON.stringify([...known, ...this.truths], null, 1)}\n`);
  }
}

/** @param normals  photos of each group at the level `normal` */
export async function writeCases(
  path: string,
  seed: number,
  normals: number,
  asked: readonly Part[] = usualParts,
): Promise<void> {
  for (const part of asked) {
    const folder = new Folder(path);
    const begin = performance.now();
    const makings = parts[part](seed, normals);
    for (const make of makings) await folder.add(await make());
    folder.list();
    const each = Math.round((performance.now() - begin) / makings.length);
    process.stderr.write(`${part}: ${makings.length} cases, ${each} ms each\n`);
  }
}
