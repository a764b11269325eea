import {describe, expect, it} from 'vitest';

import type {Failure} from '@/model/base/failure.js';
import {formatFor} from '@/texts/format.js';
import {drapeTexts} from '@/texts/drape-texts.js';
import {languages} from '@/texts/preferences.js';
import {loadTexts} from '@/texts/texts.js';
import {tightnessOf} from '@/workbench/drape/spoken-tightness.js';

const tooSmall = (girth: Partial<Failure>): Failure => ({
  ...{code: 'notAGarment', reason: 'drapeTooSmall', message: '', piece: null, seam: null},
  ...girth,
});

describe('a garment that is too tight to drape', () => {
  it.each(languages)('says in %s where, by how much, and which form it fits', async (language) => {
    await loadTexts(language);
    const words = drapeTexts(language);
    const format = formatFor(language, 'cm');
    const failure = tooSmall({lengthCm: 3.4, measure: 'upper arm', fits: 'XS'});
    expect(tightnessOf(failure, words, format)).toEqual({
      sentence: words.tooTight(format.length(3.4), words.at['upper arm']),
      fits: 'XS',
    });
  });

  it('offers no form that does not fit, and says nothing of a girth that is not known', () => {
    const [words, format] = [drapeTexts('en'), formatFor('en', 'cm')];
    expect(tightnessOf(tooSmall({lengthCm: 1.1, measure: 'hip'}), words, format)).toEqual({
      sentence: 'The garment is 1.1 cm too tight at the hip for this form.',
      fits: undefined,
    });
    expect(tightnessOf(tooSmall({}), words, format)).toBeUndefined();
  });
});
