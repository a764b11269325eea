/** Each code in the sources of the core has a text in the page's languages. */
import {readdirSync, readFileSync} from 'node:fs';

import {describe, expect, it} from 'vitest';

import type {DrapeNoteCode} from '@/model/result/draped-garment.js';
import {
  drapeReasons,
  failureCodes,
  layReasons,
  photoFaults,
  symmetryReasons,
  type Failure,
} from '@/model/base/failure.js';
import {noteCodes} from '@/model/result/notes.js';
import {drapeTexts} from '@/texts/drape-texts.js';
import {formatFor} from '@/texts/format.js';
import {languages} from '@/texts/preferences.js';
import {loadTexts, textsOf} from '@/texts/texts.js';
import {spokenDrapeNotes} from '@/workbench/drape/spoken-drape-notes.js';
import {spokenFailure} from '@/workbench/spoken-failure.js';
import type {Workbench} from '@/workbench/workbench.js';

const core = readdirSync('wasm/src', {recursive: true, encoding: 'utf8'})
  .filter((name) => /\.(cpp|h)$/.test(name))
  .map((name) => readFileSync(`wasm/src/${name}`, 'utf8'))
  .join('\n');

const found = (pattern: RegExp): readonly string[] =>
  [...new Set([...core.matchAll(pattern)].map(([, code = '']) => code))].sort();

const notes = found(/(?:\bNote|[nN]otes?_?(?:\.|->)push_back\(|return \{)\s*\{\s*"(\w+)"/g);
const isOfDrape = (code: string): code is DrapeNoteCode => code.startsWith('drape');
const drapeNotes = notes.filter(isOfDrape);
const reasons = found(/"((?:symmetry|lay|drape)[A-Z]\w+)"/g).filter(
  (code) => !notes.includes(code) && code !== 'symmetryName',
);
const failures = found(/\bFailure::k(\w+)/g)
  .map((name) => name.charAt(0).toLowerCase() + name.slice(1))
  .filter((name) => name !== 'none');

const english = 'What the core wrote.';
const failure = (more: Partial<Failure>): Failure => ({
  ...{code: 'options', message: english, piece: 0, seam: null, ...more},
});

it('the page knows all codes of the core', () => {
  expect(notes.length).toBeGreaterThan(16);
  expect(
    notes.filter((code) => !isOfDrape(code) && !noteCodes.some((one) => one === code)),
  ).toEqual([]);
  const known: readonly string[] = [...symmetryReasons, ...layReasons, ...drapeReasons];
  expect(reasons.filter((reason) => !known.includes(reason))).toEqual([]);
  expect(failures.filter((code) => !Object.hasOwn(failureCodes, code))).toEqual([]);
  expect(
    found(/Failure::kPicture,[^;]*?"(\w+)"\s*\}/g).filter(
      (code) => !photoFaults.some((one) => one === code),
    ),
  ).toEqual([]);
});

describe.each(languages)('in %s', (language) => {
  const workbench = {
    history: {design: undefined},
    sheet: {scenes: {now: {pieces: [{label: 'Yoke'}]}}},
    preferences: {chosen: {language, units: 'cm'}},
  } as unknown as Workbench;

  it('each failure of the core is translated', async () => {
    await loadTexts(language);
    const texts = textsOf(language);
    const codes = Object.keys(failureCodes).filter((code) => code !== 'cancelled');
    for (const code of codes as Failure['code'][]) {
      const spoken = spokenFailure(failure({code}), workbench, texts);
      expect(spoken, code).toContain(english);
      if (language !== 'en') expect(spoken, code).not.toBe(english);
    }
  });

  it('failures of layouts and drapes name the piece and the width', async () => {
    await loadTexts(language);
    const texts = textsOf(language);
    for (const reason of [...layReasons, 'drapeFar', 'drapeUnsewn'] as const)
      expect(spokenFailure(failure({reason}), workbench, texts), reason).toMatch(/Yoke.*\.$/);
    for (const reason of drapeReasons)
      expect(spokenFailure(failure({reason, piece: null}), workbench, texts)).toBeTruthy();
    const tooWide = failure({reason: 'layTooWide', lengthCm: 61.4});
    expect(spokenFailure(tooWide, workbench, texts)).toMatch(/Yoke.*61[.,]4/);
  });

  it('each note on a drape has its own text', () => {
    const spoken = spokenDrapeNotes(
      {
        notes: drapeNotes.map(() => english),
        noteDetails: drapeNotes.map((code) => ({code, number: 2})),
      },
      drapeTexts(language),
      formatFor(language, 'cm'),
    );
    expect(new Set(spoken).size).toBe(drapeNotes.length);
    expect(spoken).not.toContain(english);
  });
});
