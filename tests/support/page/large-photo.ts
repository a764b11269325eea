/** A photo of a camera's full resolution, for the dialog. */
import {mkdtemp, rm, writeFile} from 'node:fs/promises';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

import type {Page} from 'playwright-core';
import {afterAll, beforeAll} from 'vitest';

import {jpegOf} from '../photo/files.js';
import type {Rgba} from '../photo/pixels.js';
import {floralCase} from '../photo/print-cases.js';

/** Enlarges by this factor in both directions, which is faster than drawing a full-size image. */
function enlarged({width, height, data}: Rgba, factor: number): Rgba {
  const [across, down] = [factor * width, factor * height];
  const from = new Uint32Array(data.buffer, data.byteOffset, width * height);
  const pixels = new Uint32Array(across * down);
  for (let y = 0; y < down; y++) {
    const row = Math.floor(y / factor) * width;
    for (let x = 0; x < across; x++) {
      pixels[y * across + x] = from[row + Math.floor(x / factor)] ?? 0;
    }
  }
  return {width: across, height: down, data: new Uint8ClampedArray(pixels.buffer)};
}

/** Writes the photo for one test file. @returns a function that chooses it in the dialog */
export function useLargePhoto(): (page: Page) => Promise<void> {
  let folder: string;
  beforeAll(async () => {
    const {pixels} = await floralCase(
      {name: 'large', level: 'scan', seed: 11, size: [800, 600]},
      'pmm',
    );
    folder = await mkdtemp(join(tmpdir(), 'seamwise-large-'));
    await writeFile(join(folder, 'large.jpg'), await jpegOf(enlarged(pixels, 5), 90));
  }, 240_000);
  afterAll(() => rm(folder, {recursive: true}));
  // uploads a file, as a script on the page would have to decode bytes
  return (page) =>
    page.locator('sw-photo input[type=file]').first().setInputFiles(join(folder, 'large.jpg'));
}
