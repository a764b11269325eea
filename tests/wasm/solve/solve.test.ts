import {readFileSync} from 'node:fs';

import {convert, memory, solve, symmetries, type Progress} from 'seamwise/node';
import {describe, expect, it} from 'vitest';

import {checks, sample, twoStrips} from '../../support/garments/samples.js';

const strips = {garment: twoStrips(), print: checks};

/** The parts of a result that equal runs share, as text. */
function withoutTimes(result: Awaited<ReturnType<typeof solve>>): string {
  const milliseconds = {alignment: 0, deformation: 0, total: 0};
  return JSON.stringify({...result, metrics: {...result.metrics, milliseconds}});
}

describe('solve', () => {
  it('matches the print along a straight seam', async () => {
    const {format, units, pieces, seams, metrics} = await solve({...strips, symmetry: 'none'});
    expect({format, units}).toEqual({format: 'seamwise-result/1', units: 'cm'});
    expect(pieces.map((piece) => piece.name)).toEqual(['left', 'right']);
    expect(seams).toHaveLength(1);
    expect(metrics.fit).toBeLessThan(1e-6);
    expect(metrics.fitRandom).toBeGreaterThan(1);
    expect(metrics).toMatchObject({method: 'best', seed: 1});
  });

  it('takes JSON texts as well as objects', async () => {
    const texts = {garment: JSON.stringify(strips.garment), print: JSON.stringify(strips.print)};
    expect(withoutTimes(await solve(texts))).toBe(withoutTimes(await solve(strips)));
  });

  it('gives the same bytes for the same seed', async () => {
    const problem = {garment: sample('gathered-skirt'), print: checks, seed: 7};
    const [first, second] = [await solve(problem), await solve(problem)];
    expect(withoutTimes(first)).toBe(withoutTimes(second));
  });

  it('gives the same bytes whether solves share the thread or not', async () => {
    const problem = {garment: sample('tee'), print: checks};
    const alone = withoutTimes(await solve(problem));
    const together = await Promise.all([solve(problem), solve(strips), solve(problem)]);
    expect(withoutTimes(together[0])).toBe(alone);
    expect(withoutTimes(together[2])).toBe(alone);
  });

  it.each(['best', 'paper', 'ws19'] as const)('knows the method %s', async (method) => {
    const {metrics} = await solve({...strips, method});
    expect(metrics.method).toBe(method);
  });

  it('counts the time spent in each phase', async () => {
    const seed = 4711; // a new seed, as results of earlier searches are reused
    const {metrics} = await solve({garment: sample('tee'), print: checks, seed});
    const {milliseconds} = metrics;
    expect(milliseconds.alignment).toBeGreaterThan(0);
    expect(milliseconds.deformation).toBeGreaterThan(0);
    expect(milliseconds.total).toBeGreaterThanOrEqual(
      milliseconds.alignment + milliseconds.deformation - 1,
    );
  });
});

describe('the greatest change', () => {
  it('leaves no garment as drafted that can be shaped with less change', async () => {
    const print = readFileSync(new URL('../../../public/prints/p4m.json', import.meta.url), 'utf8');
    const problem = {garment: sample('shift-dress'), print, options: {maxChangeCm: 0.5}};
    const {metrics} = await solve(problem);
    expect(metrics.maxMovedCm).toBeGreaterThan(0.1);
  });

  it('of 0 keeps every line', async () => {
    const {metrics} = await solve({...strips, symmetry: 'none', options: {maxChangeCm: 0}});
    expect(metrics.maxMovedCm).toBe(0);
    const tee = {garment: sample('tee'), print: checks, options: {maxChangeCm: 0}};
    expect((await solve(tee)).metrics.maxMovedCm).toBeLessThan(1e-3);
  });

  it('is kept by the published methods after attempts whose time counts apart', async () => {
    const {metrics} = await solve({
      garment: sample('six-gore-skirt'),
      print: checks,
      method: 'ws19',
    });
    const {attempts = 0, deformation} = metrics.milliseconds;
    expect(metrics.maxMovedCm).toBeLessThanOrEqual(1);
    expect(attempts).toBeGreaterThan(deformation);
  });
});

describe('progress', () => {
  it('never falls, ends at 1 and passes from phase to phase once', async () => {
    const steps: Progress[] = [];
    await solve(
      {garment: sample('tee'), print: checks},
      {onProgress: (progress) => steps.push(progress)},
    );
    const fractions = steps.map((step) => step.fraction);
    expect(fractions).toEqual([...fractions].sort((a, b) => a - b));
    expect(fractions.at(-1)).toBe(1);
    expect(fractions.every((fraction) => fraction >= 0 && fraction <= 1)).toBe(true);
    const changes = steps.filter((step, k) => k > 0 && step.phase !== steps[k - 1]?.phase);
    expect(steps[0]).toEqual({phase: 'preparation', fraction: 0});
    expect(changes.map((step) => step.phase)).toEqual(['alignment', 'deformation']);
  });

  it('shows where the pieces lie, one angle and shift for each', async () => {
    const shown: Float64Array[] = [];
    await solve(
      {garment: sample('tee'), print: checks},
      {onPartial: (alignments) => shown.push(alignments)},
    );
    expect(shown.length).toBeGreaterThan(0);
    expect(shown.every((alignments) => alignments.length === 12)).toBe(true);
    expect(shown.every((alignments) => alignments.every(Number.isFinite))).toBe(true);
  });

  it('lets the thread breathe', async () => {
    let ticks = 0;
    const clock = setInterval(() => (ticks += 1), 1);
    await solve({garment: sample('tee'), print: checks, seed: 5}); // not solved before
    clearInterval(clock);
    expect(ticks).toBeGreaterThan(1);
  });

  it('passes on what a listener throws, and solves again afterwards', async () => {
    const broken = new Error('listener');
    const onProgress = () => {
      throw broken;
    };
    await expect(solve(strips, {onProgress})).rejects.toBe(broken);
    await expect(solve(strips)).resolves.toBeDefined();
  });
});

describe('cancelling', () => {
  it('rejects at once when the signal has fired already', async () => {
    await expect(solve(strips, {signal: AbortSignal.abort()})).rejects.toMatchObject({
      name: 'AbortError',
    });
  });

  it('rejects before the next slice of a solve and gives its memory back', async () => {
    const problem = {garment: sample('princess-dress'), print: checks};
    await solve(problem); // keeps the mesh in either case
    const before = (await memory()).live;
    const controller = new AbortController();
    let reportsAfterwards = 0;
    const onProgress = ({fraction}: {fraction: number}) => {
      if (controller.signal.aborted) reportsAfterwards += 1;
      else if (fraction > 0) controller.abort();
    };
    const hooks = {signal: controller.signal, onProgress};
    await expect(solve(problem, hooks)).rejects.toMatchObject({name: 'AbortError'});
    expect(reportsAfterwards).toBe(0);
    expect((await memory()).live).toBeLessThan(before + 100_000);
  });

  it("rejects with the signal's own reason", async () => {
    const reason = new Error('changed my mind');
    await expect(solve(strips, {signal: AbortSignal.abort(reason)})).rejects.toBe(reason);
  });
});

describe('input', () => {
  it('may be bytes, as they were read from a file', async () => {
    const bytes = new TextEncoder().encode(JSON.stringify(strips.garment));
    const result = await solve({...strips, garment: bytes as unknown as string});
    expect(result).toMatchObject({pieces: (await solve(strips)).pieces});
  });
});

describe('errors', () => {
  it.each([
    ['text that is no JSON', {...strips, garment: '{'}, 'notJson'],
    ['a garment without panels', {...strips, garment: '{"pattern": {"panels": {}}}'}, 'noPanels'],
    [
      'an unknown group',
      {...strips, print: '{"group": "p9", "w1": [1,0], "w2": [0,1]}'},
      'groupUnknown',
    ],
    [
      'a lattice that is not square',
      {...strips, print: {...checks, w2: [0, 5] as const}},
      'lattice',
    ],
    ['an unknown option', {...strips, options: '{"speed": 3}'}, 'options'],
    ['a bound that is no number', {...strips, options: {maxChangeCm: NaN}}, 'number'],
    ['an endless lattice', {...strips, print: {...checks, w1: [Infinity, 0] as const}}, 'number'],
    ['a seed that is no whole number', {...strips, seed: 1.5}, 'options'],
    ['a method nobody knows', {...strips, method: 'magic' as 'best'}, 'options'],
    ['a missing garment', {...strips, garment: undefined as unknown as string}, 'notJson'],
    ['symmetries that are none', {...strips, symmetry: '{"symmetries": 3}'}, 'symmetryMalformed'],
  ])('names what is wrong with %s', async (_, problem, code) => {
    await expect(solve(problem)).rejects.toMatchObject({
      name: 'SolverError',
      code,
      message: expect.stringMatching(/^\S.*\.$/) as string,
    });
  });

  it('calls files by the names that are given, and the others by what they are', async () => {
    const names = {garment: 'a.json'};
    await expect(solve({...strips, garment: '{'}, {names})).rejects.toThrow(/^a\.json /);
    await expect(solve({...strips, print: '{'}, {names})).rejects.toThrow(/^print /);
  });

  it('says which seam is to blame', async () => {
    const {panels} = twoStrips().pattern;
    const ends = [
      {panel: 'left', edge: 1},
      {panel: 'sleeve', edge: 3},
    ] as const;
    const garment = {pattern: {panels, stitches: [ends]}};
    await expect(solve({...strips, garment})).rejects.toMatchObject({
      code: 'seamUnknownPiece',
      seam: 0,
      message: expect.stringContaining('sleeve') as string,
    });
  });

  it('leave the solver as good as before', async () => {
    const good = withoutTimes(await solve(strips));
    await expect(solve({...strips, garment: '{'})).rejects.toThrow();
    expect(withoutTimes(await solve(strips))).toBe(good);
  });
});

describe('garments', () => {
  it('show their symmetries', async () => {
    const {symmetries: found} = await symmetries(twoStrips());
    expect(found.length).toBeGreaterThan(0);
    expect(found.every((symmetry) => symmetry.residual <= 0.1)).toBe(true);
    await expect(solve({...strips, symmetry: {symmetries: found}})).resolves.toBeDefined();
  });

  it('convert to a format that reads back as the same garment', async () => {
    const converted = await convert(twoStrips());
    expect(JSON.parse(converted)).toMatchObject({format: 'seamwise-garment/1'});
    const garment = converted;
    expect(withoutTimes(await solve({...strips, garment}))).toBe(withoutTimes(await solve(strips)));
  });
});
