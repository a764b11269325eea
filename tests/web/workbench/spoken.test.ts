/** The core's English messages, translated by the page to its user's language. */
import {describe, expect, it} from 'vitest';

import {symmetryReasons} from '@/model/base/failure.js';
import {noteCodes, type NoteDetail} from '@/model/result/notes.js';
import {failureCodes, type Failure} from '@/model/base/failure.js';
import {spokenNote} from '@/workbench/lists/spoken-note.js';
import {formatFor} from '@/texts/format.js';
import {loadTexts, textsOf} from '@/texts/texts.js';
import {languages, type Language} from '@/texts/preferences.js';
import {spokenFailure} from '@/workbench/spoken-failure.js';
import type {Workbench} from '@/workbench/workbench.js';

/** The part of a workbench from which messages take names. */
const workbench = {
  history: {design: {print: {group: 'p1'}}},
  sheet: {scenes: {now: {pieces: [{label: 'Front'}, {label: 'Back'}]}}},
  solving: {},
  preferences: {chosen: {language: 'en', units: 'cm'}},
} as unknown as Workbench;

const detailOf = (code: string): NoteDetail => ({
  ...{code, pieces: [0, 1], seams: [], numbers: [1.25, 1]},
});
const english = 'What the core wrote.';
const note = (code: string, language: Language): string =>
  spokenNote(english, detailOf(code), workbench, textsOf(language), formatFor(language, 'cm'));
const failure = (more: Partial<Failure>): Failure => ({
  ...{code: 'symmetryConflict', message: english, piece: 0, seam: null, ...more},
});

describe.each(languages)('in %s', (language) => {
  it('every note has a sentence of its own', async () => {
    await loadTexts(language);
    const all = noteCodes.map((code) => note(code, language));
    expect(all.filter((one) => one === english || !one.endsWith('.'))).toEqual([]);
    expect(new Set(all).size).toBe(all.length);
  });

  it('notes name pieces and figures', async () => {
    await loadTexts(language);
    for (const code of ['symmetryPins', 'noMirrors', 'noGlides', 'grainAssumed'])
      expect(note(code, language)).toMatch(/Front.*Back/);
    expect(note('noMirrors', language)).not.toContain('p1'); // codes are for files
    expect(note('lengthRatio', language)).toMatch(/1[.,]25/);
  });

  it('a note and a failure that are not known stay as they were written', async () => {
    await loadTexts(language);
    expect(note('fromTheFuture', language)).toBe(english);
    expect(
      spokenNote(english, undefined, workbench, textsOf(language), formatFor(language, 'cm')),
    ).toBe(english);
    expect(spokenFailure(failure({code: 'network'}), workbench, textsOf(language))).toBe(english);
  });

  it('a symmetry that cannot hold says why', async () => {
    await loadTexts(language);
    const texts = textsOf(language);
    for (const reason of symmetryReasons) {
      const said = spokenFailure(failure({reason}), workbench, texts);
      expect(said).toContain('Front');
      expect(said).toContain(texts.notes.why[reason]);
    }
    const both = spokenFailure(failure({reason: 'symmetryPins'}), workbench, texts, 'Front, Back');
    expect(both).toContain('Front, Back');
    expect(spokenFailure(failure({code: 'symmetryGroup'}), workbench, texts)).not.toMatch(/p1|pmm/);
  });

  it('a file that cannot be read is said to be a garment’s, around the place in it', async () => {
    await loadTexts(language);
    for (const code of Object.keys(failureCodes) as (keyof typeof failureCodes)[]) {
      const said = spokenFailure(failure({code}), workbench, textsOf(language));
      if (failureCodes[code] >= 10 && failureCodes[code] < 40) {
        expect(said).toContain(english);
        if (language !== 'en') expect(said.length).toBeGreaterThan(english.length);
      }
    }
  });
});
