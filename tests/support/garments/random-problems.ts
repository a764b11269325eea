/** Random problems around random garments, and random damage to them. */
import * as fc from 'fast-check';
import {
  type GroupName,
  type Method,
  type Point,
  type Print,
  type SolveOptions,
  type Symmetries,
} from 'seamwise/node';

import {groupNames} from '@/model/base/core-tables.js';
import {latticeType} from '@/model/print/wallpaper.js';
import {rotated} from '@/model/geometry/vectors.js';
import {at} from '../plane.js';
import {between, draftedGarment, type DraftedGarment} from './random-garments.js';

/** A problem as JSON texts, like files. */
export interface ProblemText {
  readonly garment: string;
  readonly print: string;
  readonly symmetry: string;
  readonly options: string;
  readonly method: Method;
  readonly seed: number;
}

function lattice(group: GroupName): fc.Arbitrary<readonly [Point, Point]> {
  const basis = fc
    .record({a: between(1.5, 9), b: between(1.5, 9), angle: between(0.6, 2.5), by: between(-4, 4)})
    .map(({a, b, angle, by}) => {
      const bases: Readonly<Record<ReturnType<typeof latticeType>, readonly [number, number]>> = {
        oblique: [b, angle],
        rectangular: [b, Math.PI / 2],
        rhombic: [a, angle],
        square: [a, Math.PI / 2],
        hexagonal: [a, Math.PI / 3],
      };
      const [length, opening] = bases[latticeType(group)];
      const w1 = rotated([a, 0], by);
      const w2 = rotated([length, 0], by + opening);
      return [w1, w2] as const;
    });
  const upright = basis.map(([w1, w2]): readonly [Point, Point] => {
    const by = -Math.atan2(w1[1], w1[0]);
    return [rotated(w1, by), rotated(w2, by)];
  });
  return fc.oneof(basis, upright);
}

const print: fc.Arbitrary<Print> = fc.constantFrom(...groupNames).chain((group) =>
  fc
    .record(
      {
        group: fc.constant(group),
        basis: lattice(group),
        oneWay: fc.boolean(),
      },
      {requiredKeys: ['group', 'basis']},
    )
    .map(({basis: [w1, w2], ...rest}) => ({...rest, w1, w2})),
);

const lock = fc.constantFrom('free', 'on', 'across', 'bias');

/** One value per key, for some of the keys. */
const forSome = <T>(keys: readonly string[], value: fc.Arbitrary<T>) =>
  fc
    .subarray([...keys], {maxLength: Math.min(keys.length, 2)})
    .chain((chosen) =>
      fc
        .tuple(...chosen.map(() => value))
        .map((values) => Object.fromEntries(chosen.map((key, k) => [key, at(values, k)]))),
    );

function options({garment, names}: DraftedGarment): fc.Arbitrary<SolveOptions> {
  const seams = (garment.pattern.stitches ?? []).map((_, k) => k);
  const rule = fc.oneof(
    lock,
    fc.record(
      {lock, toleranceDeg: between(0, 90), angleDeg: between(-360, 360)},
      {requiredKeys: ['lock']},
    ),
    fc.record({angleDeg: between(-360, 360)}),
  );
  return fc.record(
    {
      maxChangeCm: fc.oneof(between(0, 2), between(0, 0.1), fc.constant(0)),
      edgeLengthCm: between(0.3, 1.05),
      continuousOnly: fc.boolean(),
      averageSeamShapes: fc.boolean(),
      proof: between(0, 0.3),
      grain: fc.record(
        {default: lock, toleranceDeg: between(0, 90), pieces: forSome(names, rule)},
        {requiredKeys: []},
      ),
      weights: forSome(seams.map(String), fc.oneof(fc.constant(0), between(0, 100))),
      unmatched: fc.subarray(seams),
      plain: fc.subarray([...names], {maxLength: 1}),
      pins: forSome(
        names,
        fc.record({
          angle: between(-10, 10),
          translation: fc.tuple(between(-50, 50), between(-50, 50)),
        }),
      ),
    },
    {requiredKeys: []},
  );
}

function symmetry({symmetries: {symmetries}}: DraftedGarment): fc.Arbitrary<Symmetries | string> {
  return fc.oneof(
    {weight: 3, arbitrary: fc.constant('auto')},
    fc.constant('none'),
    fc.subarray([...symmetries]).map((some) => ({symmetries: some})),
  );
}

/** A garment with random values of all settings of a solve. */
export const problem: fc.Arbitrary<ProblemText> = draftedGarment.chain((drafted) =>
  fc
    .record({
      print,
      symmetry: symmetry(drafted),
      options: fc.oneof(fc.constant({}), options(drafted)),
      method: fc.nat(9).map((k): Method => (k === 8 ? 'paper' : k === 9 ? 'ws19' : 'best')),
      seed: fc.nat(),
    })
    .map(({print, symmetry, options, method, seed}) => ({
      garment: JSON.stringify(drafted.garment),
      print: JSON.stringify(print),
      symmetry: typeof symmetry === 'string' ? symmetry : JSON.stringify(symmetry),
      options: JSON.stringify(options),
      method,
      seed,
    })),
);

const documents = ['garment', 'garment', 'garment', 'print', 'options', 'symmetry'] as const;

/** Wrong values for any place, as texts, since JSON.stringify cannot write some of the numbers. */
const nonsense = [
  'null', 'true', '""', '"front"', '"1"', '[]', '{}', '[1]', '[0,0]', '[[]]', '{"a":1}', '-1', '0', '-0', '1',
  '2', '0.5', '1e-9', '1e-300', '1e7', '1e20', '1e308', '1e999', '-1e308', 'NaN', 'Infinity', '2147483648', '4294967296',
  '"\\ud800"',
] as const; // prettier-ignore

type Damage =
  | {readonly kind: 'replace'; readonly by: string}
  | {readonly kind: 'delete' | 'negate' | 'repeat' | 'reverse'}
  | {readonly kind: 'scale'; readonly factor: number}
  | {readonly kind: 'cut' | 'byte'; readonly place: number; readonly by: string};

const damage: fc.Arbitrary<Damage> = fc.oneof(
  {
    weight: 4,
    arbitrary: fc.record({kind: fc.constant('replace'), by: fc.constantFrom(...nonsense)}),
  },
  {
    weight: 3,
    arbitrary: fc.record({kind: fc.constantFrom('delete', 'negate', 'repeat', 'reverse')}),
  },
  fc.record({kind: fc.constant('scale'), factor: fc.constantFrom(0, 1e-4, 0.1, 3, 1e6)}),
  fc.record({
    kind: fc.constantFrom('cut', 'byte'),
    place: between(0, 1),
    by: fc.constantFrom('', '"', '{', ']', ',', '\u0000', '\ufeff', '9', '-', 'é', '\n'),
  }),
);

/** A problem with one or two errors, or at least differences, in one of its files. */
export const damagedProblem: fc.Arbitrary<ProblemText> = fc
  .record({
    intact: problem,
    which: fc.constantFrom(...documents),
    damages: fc.array(fc.record({damage, place: fc.nat()}), {minLength: 1, maxLength: 2}),
  })
  .map(({intact, which, damages}) => ({
    ...intact,
    [which]: damages.reduce((text, {damage, place}) => damaged(text, damage, place), intact[which]),
  }));

function damaged(text: string, harm: Damage, place: number): string {
  if (harm.kind === 'cut') return text.slice(0, Math.floor(harm.place * text.length)) + harm.by;
  if (harm.kind === 'byte') {
    const k = Math.floor(harm.place * text.length);
    return text.slice(0, k) + harm.by + text.slice(k + 1);
  }
  let document: unknown;
  try {
    document = JSON.parse(text);
  } catch {
    return text; // too damaged to have parts
  }
  const slots = slotsOf(document);
  const slot = slots[place % Math.max(slots.length, 1)];
  if (!slot) return harm.kind === 'replace' ? harm.by : text;
  const {holder, key} = slot;
  const marker = '\ufffdhere\ufffd';
  switch (harm.kind) {
    case 'delete':
      if (Array.isArray(holder)) holder.splice(Number(key), 1);
      else Reflect.deleteProperty(holder, key);
      break;
    case 'repeat':
      if (Array.isArray(holder)) holder.push(holder[Number(key)]);
      else Reflect.set(holder, `${key}2`, Reflect.get(holder, key));
      break;
    case 'reverse':
      if (Array.isArray(holder)) holder.reverse();
      break;
    case 'negate':
      numbersAt(holder, key, (value) => -value);
      break;
    case 'scale':
      numbersAt(holder, key, (value) => value * harm.factor);
      break;
    case 'replace':
      Reflect.set(holder, key, marker);
      return JSON.stringify(document).replace(JSON.stringify(marker), () => harm.by);
  }
  return JSON.stringify(document);
}

function numbersAt(holder: object, key: string, change: (value: number) => number): void {
  const value: unknown = Reflect.get(holder, key);
  if (typeof value === 'number') Reflect.set(holder, key, change(value));
}

interface Slot {
  readonly holder: object;
  readonly key: string;
}

/** Every place of a document that has a value, except its root. */
function slotsOf(value: unknown): Slot[] {
  if (typeof value !== 'object' || value === null) return [];
  return Object.entries(value).flatMap(([key, inner]) => [{holder: value, key}, ...slotsOf(inner)]);
}
