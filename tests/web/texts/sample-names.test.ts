import {readdirSync, readFileSync} from 'node:fs';

import {describe, expect, it} from 'vitest';

import type {GarmentDocument, GarmentSeam} from '@/model/garment/garment-document.js';
import {panelMarks} from '@/model/garment/panel-marks.js';
import {de} from '@/texts/de.js';
import {en} from '@/texts/en.js';
import {es} from '@/texts/es.js';
import {fr} from '@/texts/fr.js';
import {it as italian} from '@/texts/it.js';
import {withSampleNames} from '@/texts/sample-names.js';
import {documentOf, draftedSeam, draftedSquare} from '../../support/garments/documents.js';

interface SampleFile {
  readonly pattern: {readonly panels: Readonly<Record<string, {readonly label: string}>>};
  readonly seams: readonly Pick<GarmentSeam, 'name'>[];
}

/** The names of a sample garment as a document. */
function sample(file: string): GarmentDocument {
  const {pattern, seams} = JSON.parse(
    readFileSync(`public/garments/${file}`, 'utf8'),
  ) as SampleFile;
  return documentOf(
    Object.entries(pattern.panels).map(([name, {label}]) => draftedSquare(name, {label})),
    {seams: seams.map((seam) => draftedSeam(seam))},
  );
}

const files = readdirSync('public/garments').filter((name) => name.endsWith('-m.json'));
const garments = new Map(files.map((file) => [file, sample(file)]));

const labels = (garment: GarmentDocument): readonly string[] =>
  [...panelMarks(garment).values()].map(({label}) => label);

describe.each(Object.entries({de, es, fr, it: italian}))('sample names in %s', (_, texts) => {
  it.each(files)('name each piece of %s once, and each seam', (file) => {
    const garment = garments.get(file) ?? documentOf([]);
    const shown = withSampleNames(garment, file, texts);
    const english = new Set(labels(garment));
    const own = labels(shown);
    expect(own.filter((name) => english.has(name) || /[[\]/]/.test(name))).toEqual([]);
    expect(new Set(own).size).toBe(own.length);
    const seams = new Set(garment.seams.map(({name}) => name));
    expect(shown.seams.filter(({name}) => seams.has(name))).toEqual([]);
  });
});

it('names sides as tailors do', () => {
  const shown = (file: string, texts: typeof en): string =>
    labels(withSampleNames(garments.get(file) ?? documentOf([]), file, texts)).join(', ');
  expect(shown('tee-m.json', de)).toBe('Vorderteil, Rückenteil, Ärmel links, Ärmel rechts');
  expect(shown('tee-m.json', fr)).toBe('Devant, Dos, Manche gauche, Manche droite');
  expect(shown('trousers-m.json', es)).toMatch(/^Delantero izquierdo, .*Cinturilla derecha$/);
});

it('leaves other garments, and English, as they are', () => {
  const garment = garments.get('tee-m.json') ?? documentOf([]);
  expect(withSampleNames(garment, 'my-tee.json', de)).toBe(garment);
  expect(withSampleNames(garment, 'tee-m.json', en)).toBe(garment);
  expect(withSampleNames(garment, 'tee-m.json', de)).toBe(
    withSampleNames(garment, 'tee-m.json', de),
  );
});
