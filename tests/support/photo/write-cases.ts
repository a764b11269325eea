/** Writes cases into a folder: NAME.rgba, NAME.cell.rgba, some as files too, and cases.json. */
import {mkdirSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';

import {cellPixels, type CaseTruth, type PhotoCase} from './case.js';
import {jpegOf, rawOf, stored, withExif, type Orientation} from './files.js';
import {allGroups} from './group-elements.js';
import {floralCase} from './print-cases.js';

type Making = () => Promise<PhotoCase>;

function printMakings(seed: number, normals: number, hards: number): readonly Making[] {
  const size: readonly [number, number] = [960, 720];
  const of = (level: 'scan' | 'normal' | 'hard', count: number, from: number): readonly Making[] =>
    allGroups.flatMap((group, g) =>
      Array.from({length: count}, (_, k): Making => () =>
        floralCase({
          name: `${level}-${group}-${k + 1}`,
          group,
          level,
          seed: seed + from + 100 * g + k,
          size,
        }),
      ),
    );
  return [...of('normal', normals, 0), ...of('scan', 1, 10_000), ...of('hard', hards, 20_000)];
}

class Folder {
  private readonly truths: CaseTruth[] = [];

  constructor(private readonly path: string) {
    mkdirSync(path, {recursive: true});
  }

  async add({truth, pixels, cell}: PhotoCase): Promise<void> {
    const write = (ending: string, bytes: Buffer): void => {
      writeFileSync(join(this.path, `${truth.name}${ending}`), bytes);
    };
    write('.rgba', rawOf(pixels));
    if (cell) write('.cell.rgba', rawOf(cellPixels(cell)));
    if (this.truths.length % 5 === 0) {
      const orientation = (1 + ((this.truths.length / 5) % 8)) as Orientation;
      const jpeg = await jpegOf(stored(pixels, orientation), 95);
      write('.jpg', withExif(jpeg, orientation, truth.f35 ?? undefined));
    }
    this.truths.push(truth);
    writeFileSync(join(this.path, 'cases.json'), `${JSON.stringify(this.truths, null, 1)}\n`);
  }
}

export async function writeCases(path: string, seed: number, normals: number): Promise<void> {
  const folder = new Folder(path);
  for (const make of printMakings(seed, normals, 2)) {
    const begin = performance.now();
    const made = await make();
    await folder.add(made);
    process.stderr.write(`${made.truth.name} ${Math.round(performance.now() - begin)} ms\n`);
  }
}
