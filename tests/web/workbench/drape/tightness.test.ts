import {describe, expect, it} from 'vitest';

import {formatFor} from '@/texts/format.js';
import {drapeTexts} from '@/texts/drape-texts.js';
import {languages} from '@/texts/preferences.js';
import {loadTexts} from '@/texts/texts.js';
import {tightnessOf} from '@/workbench/drape/spoken-tightness.js';

const tooSmall = (girth: string) => ({
  code: 'notAGarment' as const,
  reason: 'drapeTooSmall' as const,
  message: `result: The garment is too small for its form${girth}: give the measurements.`,
  piece: null,
  seam: null,
});

describe('a garment that is too tight to drape', () => {
  it.each(languages)('says in %s where, by how much, and which form it fits', async (language) => {
    await loadTexts(language);
    const words = drapeTexts(language);
    const format = formatFor(language, 'cm');
    const failure = tooSmall(' by 3.4 cm at the upper arm (it fits size XS)');
    expect(tightnessOf(failure, words, format)).toEqual({
      sentence: words.tooTight(format.length(3.4), words.at['upper arm']),
      fits: 'XS',
    });
  });

  it('offers no form that does not fit, and says nothing of a girth that is not known', () => {
    const [words, format] = [drapeTexts('en'), formatFor('en', 'cm')];
    expect(tightnessOf(tooSmall(' by 1.1 cm at the hip'), words, format)).toEqual({
      sentence: 'The garment is 1.1 cm too tight at the hip for this form.',
      fits: undefined,
    });
    expect(tightnessOf(tooSmall(''), words, format)).toBeUndefined();
  });
});
