/**
 * Random layouts of the sample garments on prints of all groups, with checks. `SEAMWISE_SWEEP` is
 * their number; each is reproducible by its number.
 */
import {readFileSync} from 'node:fs';

import {marker, solve, SolverError, type Print, type SolveResult} from 'seamwise/node';
import {expect, it} from 'vitest';

import {groupNames} from '@/model/base/core-tables.js';
import {planComplaints} from '../../support/marker/check-plan.js';
import {cases} from '../../support/level.js';
import {at} from '../../support/plane.js';
import {chance, randomLay} from '../../support/marker/random-lay.js';
import {sample} from '../../support/garments/samples.js';

const garments = [
  ...['tee', 'trousers', 'shirt', 'six-gore-skirt', 'raglan', 'apron', 'princess-dress'],
  ...['hoodie', 'asymmetric-dress', 'gathered-skirt', 'patchwork-jacket', 'shift-dress'],
] as const;

const count = Number(process.env.SEAMWISE_SWEEP ?? cases(3, 6));

const options = {grain: {default: 'on'}, proof: 0} as const;

/** An apron's ties, which are part of its waistband, are longer than the width of most fabrics. */
const plain = ['waistband'];

/** Options may only name existing pieces. */
const optionsFor = (garment: (typeof garments)[number]) =>
  garment === 'apron' ? {...options, plain} : options;

const printOf = (group: string): Print =>
  JSON.parse(
    readFileSync(new URL(`../../../public/prints/${group}.json`, import.meta.url), 'utf8'),
  ) as Print;

/** Possible refusals because of fabric or print. */
const refusals =
  /is [\d.]+ cm wide, more than|fits nowhere across|finds no place between|no mirror image|own mirror image|mirror image of the print|was solved upside down|cannot lie with its upper end up|not cut as mirror images|off its grain|upside down, against the nap|between selvedge and fold/;

it(
  `lays pieces where they may lie, ${count} times`,
  {timeout: 30_000 + 60_000 * count},
  async () => {
    const solved = new Map<string, SolveResult>();
    const solution = async (garment: (typeof garments)[number], group: string, shaped: boolean) => {
      const key = `${garment} ${group}`;
      const known = solved.get(key);
      if (known) return known;
      const asked = {...optionsFor(garment), ...(!shaped && {maxChangeCm: 0})};
      const result = await solve({
        ...{garment: sample(garment), print: printOf(group), options: asked},
      });
      solved.set(key, result);
      return result;
    };
    const tally = {laid: 0, refused: 0};
    for (let n = 0; n < count; n++) {
      const next = chance(n);
      const group = at(groupNames, n % groupNames.length);
      const garment = at(garments, Math.floor(n / groupNames.length + n) % garments.length);
      const laid = [
        {
          result: await solution(garment, group, n % 3 === 0),
          options: optionsFor(garment),
        },
      ];
      if (next() < 0.15) {
        const result = await solution('apron', group, false);
        laid.push({result, options: optionsFor('apron')});
      }
      const results = laid.map(({result}) => result);
      const {settings, rules} = randomLay(at(results, 0).print, next);
      const named = `${n}: ${garment} on ${group}, ${JSON.stringify(settings)}`;
      try {
        const plan = await marker(laid, settings);
        expect(planComplaints(plan, results, {...rules, plain}), named).toEqual([]);
        tally.laid += 1;
      } catch (error) {
        if (!(error instanceof SolverError)) throw error;
        expect(error.message, named).toMatch(refusals);
        tally.refused += 1;
      }
    }
    console.log(tally);
    expect(tally.laid).toBeGreaterThan(tally.refused);
  },
);
