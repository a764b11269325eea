import {readFileSync} from 'node:fs';

import {remedies, solve} from 'seamwise/node';
import {expect, it} from 'vitest';

import {finalMismatch, mismatchOf, meanOf, worstOf} from '@/scene/mismatch.js';
import {sample} from '../../support/garments/samples.js';

const print = readFileSync(new URL('../../../public/prints/cm.json', import.meta.url), 'utf8');
const problem = {
  garment: sample('gathered-skirt'),
  print,
  options: {grain: {default: 'on'}},
} as const;

it('has the same figures in the result as everywhere else, and no worst seam below the average', async () => {
  const result = await solve(problem);
  const {localCm} = result.metrics;
  const final = finalMismatch(result);
  const drafted = mismatchOf(result, 'rest', result.drafted ?? []);
  expect(localCm?.final).toBeCloseTo(final.mean, 9);
  expect(localCm?.drafted).toBeCloseTo(drafted.mean, 5);
  expect(localCm?.worst).toBeCloseTo(worstOf(final)?.mean ?? NaN, 9);
  expect(localCm?.worst).toBeGreaterThanOrEqual(localCm?.final ?? NaN);
  result.seams.forEach(({local}, k) => {
    const [seam, before] = [final.seams[k], drafted.seams[k]];
    expect(local?.final).toBeCloseTo(seam ? meanOf(seam) : NaN, 9);
    expect(local?.drafted).toBeCloseTo(before ? meanOf(before) : NaN, 5);
  });
});

it('counts no mirrored match where mirrored seams are forbidden, there and in every figure', async () => {
  const options = {...problem.options, continuousOnly: true};
  const pmm = readFileSync(new URL('../../../public/prints/pmm.json', import.meta.url), 'utf8');
  const result = await solve({garment: sample('tee'), print: pmm, options});
  const {localCm, continuous, fit} = result.metrics;
  const final = finalMismatch(result);
  expect(result.continuousOnly).toBe(true);
  expect(localCm?.final).toBeCloseTo(final.mean, 9);
  expect(continuous?.fit).toBeCloseTo(final.total, 6);
  const drafted = mismatchOf(result, 'rest', result.drafted ?? []).total;
  expect((continuous?.fitDrafted ?? NaN) / drafted).toBeCloseTo(1, 5);
  expect(fit).toBeLessThan(final.total);
});

it.each(
  ['apron', 'gathered-skirt', 'shirt'].flatMap((name) =>
    [undefined, 0].map((most) => [name, most] as const),
  ),
)(
  'has a worst seam that is no better than the average, and reasons for what misses, with the %s, changed by %s cm at most',
  async (name, maxChangeCm) => {
    const garment = readFileSync(
      new URL(`../../../public/garments/${name}-m.json`, import.meta.url),
      'utf8',
    );
    const options = {...problem.options, ...(maxChangeCm !== undefined && {maxChangeCm})};
    const result = await solve({garment, print, options});
    const {localCm} = result.metrics;
    expect(localCm?.worst).toBeGreaterThanOrEqual((localCm?.final ?? NaN) - 1e-12);
    const {seams} = finalMismatch(result);
    result.seams.forEach(({why, line, local}, k) => {
      expect(why !== undefined).toBe(seams[k]?.counts && (local?.final ?? NaN) > 0.3);
      if (maxChangeCm === 0) expect(line).toBe('drafted');
    });
  },
);

it('never misses by more than the pieces as a cutter lays them if all seams count alike', async () => {
  const text = (path: string) =>
    readFileSync(new URL(`../../../public/${path}.json`, import.meta.url), 'utf8');
  const {localCm} = (
    await solve({
      garment: text('garments/trousers-l'),
      print: text('prints/plaid'),
      options: {grain: {default: 'on'}, visibility: 'even'},
    })
  ).metrics;
  expect(localCm?.final).toBeLessThanOrEqual((localCm?.drafted ?? NaN) + 1e-9);
  expect(localCm?.final).toBeLessThanOrEqual((localCm?.placed ?? NaN) + 1e-9);
});

it('offers to leave gathers out, and says what that gains', async () => {
  const result = await solve(problem);
  expect(result.seams.filter(({why}) => why === 'gather')).not.toEqual([]);
  const [remedy] = await remedies(problem, result);
  expect(remedy).toMatchObject({kind: 'ungather', pieces: []});
  expect(remedy?.after).toBeLessThan(0.6 * (remedy?.before ?? 0));
  const tried = await solve({...problem, options: {...problem.options, ...remedy?.change.options}});
  expect(finalMismatch(tried).mean).toBeCloseTo(remedy?.after ?? NaN, 9);
});

it('takes no more time for remedies than somebody gives it', async () => {
  const result = await solve(problem);
  const reason = new Error('enough');
  await expect(remedies(problem, result, {signal: AbortSignal.abort(reason)})).rejects.toBe(reason);
});
