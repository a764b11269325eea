// Parts of the benchmark. Every part returns rows of figures in the program's own format.
import {cpus} from 'node:os';

import {exponent} from './numbers.mjs';

/** Repetitions within one process, of which the quickest counts. */
const often = {times: 3, atLeast: 1000};
/** Triangles of the paper's largest garment, and of the meshes that growth is measured on. */
const paperTriangles = 16500;
const sizes = [5e3, 20e3, 80e3, 160e3];

/** Platforms that the program runs on. */
export const both = ['native', 'wasm'];
/**
 * The garment that represents all where measuring them would take too long; it is most like the
 * paper's.
 */
const exampleOf = (garments) =>
  garments.find(({name}) => name.startsWith('princess-dress')) ?? garments[0];

/** Garments that represent all where one is not enough. */
const usualNames = ['princess-dress', 'shirt', 'trousers'];
export function usualOf(garments, thorough, names = usualNames) {
  const usual = garments.filter(
    ({name}) => thorough || names.some((one) => name.startsWith(`${one}-`)),
  );
  return usual.length > 0 ? usual : garments.slice(0, 1);
}

const named = (task, {garment, print}) => ({task, garment: garment.file, print: print.file});

/**
 * Returns the measurement, or nothing where it fails; the failure is reported and must not cost the
 * other figures.
 */
export async function unlessBroken(name, fail, measure) {
  try {
    return await measure();
  } catch (error) {
    fail(`${name}: ${error.message}`);
    return undefined;
  }
}

/** Maps the items in order; two at a time where there are enough processors. */
async function twoAtOnce(items, work) {
  const results = [];
  const left = items.entries();
  const worker = async () => {
    for (const [k, item] of left) results[k] = await work(item, k);
  };
  await Promise.all(Array.from({length: Math.min(2, cpus().length)}, worker));
  return results;
}

export const isThere = (row) => row !== undefined;

/**
 * Measures every garment by every method. best and its solve without symmetry run natively and in
 * WebAssembly, one after the other. paper and ws19, which take long, run two at once and natively;
 * in WebAssembly only for one garment, or for all when thorough.
 */
export async function measureMethods({programs, garments, prints, seeds, thorough, say, fail}) {
  const cases = garments.flatMap((garment) => prints.methods.map((print) => ({garment, print})));
  const nameOf = ({garment, print}, method) =>
    `methods: ${garment.name}, ${print.group}, ${method}`;
  const measured = (one, method, measure) => {
    say(nameOf(one, method));
    return unlessBroken(nameOf(one, method), fail, () => measure(named('solve', one)));
  };
  const rows = [];
  for (const one of cases) {
    rows.push({
      garment: one.garment.name,
      group: one.print.group,
      best: await measured(one, 'best', (task) => programs.onBoth({...task, ...often})),
      none: await measured(one, 'best without symmetry', (task) =>
        programs.onBoth({...task, ...often, symmetry: 'none'}),
      ),
    });
  }
  const slow = cases.flatMap((one, row) => ['ws19', 'paper'].map((method) => ({one, row, method})));
  await twoAtOnce(slow, async ({one, row, method}) => {
    const platforms = thorough || one.garment === exampleOf(garments) ? both : ['native'];
    rows[row][method] = await measured(one, method, async (task) => {
      const answers = {};
      for (const platform of platforms)
        answers[platform] = await medianOfSeeds(programs, platform, {...task, method}, seeds);
      return answers;
    });
  });
  return rows;
}

/** Returns the answer of the seed with the median mismatch, the lower one of two. */
async function medianOfSeeds(programs, platform, task, seeds) {
  const tasks = Array.from({length: seeds}, (_, k) => ({...task, seed: k + 1}));
  const answers = await programs.ask(platform, tasks);
  const sorted = answers.toSorted((a, b) => a.fit - b.fit);
  return sorted[Math.floor((sorted.length - 1) / 2)];
}

/** Number of print groups in which every garment is compared with the published method. */
const publishedGroups = 3;
/**
 * Options with which the published method is at its best: many starts, far targets clipped or not.
 */
const atItsBest = [{starts: 50}, {starts: 50, clipTargets: true}];

/**
 * Compares best with the published method, as published and at its best: every garment in some of
 * the groups in turn, or in all when thorough. One process a case, two at once.
 */
export async function measurePublished({programs, garments, prints, seeds, thorough, say, fail}) {
  const all = prints.published;
  const count = thorough ? all.length : Math.min(publishedGroups, all.length);
  const cases = garments.flatMap((garment, k) =>
    Array.from({length: count}, (_, j) => ({garment, print: all[(k * count + j) % all.length]})),
  );
  const rows = await twoAtOnce(cases, async (one) => {
    const name = `published: ${one.garment.name}, ${one.print.group}`;
    say(name);
    const task = {...named('solve', one), method: 'paper'};
    return unlessBroken(name, fail, async () => {
      const [best, ...tried] = await programs.ask('native', [
        {...task, method: 'best', times: 3},
        ...atItsBest.map((options) => ({...task, options})),
      ]);
      return {
        garment: one.garment.name,
        group: one.print.group,
        best,
        paper: await medianOfSeeds(programs, 'native', task, seeds),
        bestPaper: tried.reduce((a, b) => (b.fit < a.fit ? b : a)),
      };
    });
  });
  return rows.filter(isThere);
}

/** Measures one factorisation of the complete mesh and solves, on meshes of 16.5k triangles. */
export async function measureYardstick({programs, garments, prints, thorough, say, fail}) {
  const rows = [];
  const timed = usualOf(garments, thorough); // paper takes long
  for (const garment of garments) {
    say(`yardstick: ${garment.name}`);
    const files = {garment, print: prints.methods[0]};
    const measure = async () => {
      const {edgeLength, triangles} = await meshOf(programs, files, paperTriangles);
      return {
        garment: garment.name,
        triangles,
        edgeLength,
        factorisation: await programs.onBoth({...named('factorise', files), edgeLength, ...often}),
        best: await programs.onBoth({...named('solve', files), edgeLength, ...often}),
      };
    };
    const row = await unlessBroken(`yardstick: ${garment.name}`, fail, measure);
    if (row && timed.includes(garment)) {
      const task = {...named('solve', files), edgeLength: row.edgeLength, method: 'paper'};
      const [native] =
        (await unlessBroken(`yardstick: ${garment.name}, paper`, fail, () =>
          programs.ask('native', [task]),
        )) ?? [];
      if (native) row.paper = {native};
    }
    rows.push(row);
  }
  return rows.filter(isThere);
}

async function meshOf(programs, files, triangles) {
  const [mesh] = await programs.ask('native', [{...named('mesh', files), triangles}]);
  return mesh;
}

/**
 * Compares the search with 1000 random starts and, in `longCases` of the cases, with itself with
 * much more time. Seams weigh the same here, so that the mismatch is what the search minimises.
 * Only quotients of times within one process count, so that two processes may run at once.
 */
export async function measureSearch({
  programs,
  garments,
  prints,
  long,
  longCases,
  seeds,
  say,
  fail,
}) {
  const cases = garments.flatMap((garment) =>
    prints.search.flatMap((print) =>
      ['auto', 'none'].map((symmetry) => ({garment, print, symmetry})),
    ),
  );
  const longOnes = spread(long > 0 ? longCases : 0, garments.length, prints.search.length);
  const measure = async ({garment, print, symmetry}, isLong) => {
    const settings = {symmetry, evenSeams: true};
    const [starts, ...found] = await programs.ask('native', [
      {...named('starts', {garment, print}), ...settings, count: 1000},
      ...Array.from({length: seeds}, (_, k) => ({
        ...named('search', {garment, print}),
        ...settings,
        seed: k + 1,
        times: 2,
        ...(isLong && k === 0 && {long: 1000 * long}),
      })),
    ]);
    return found.map((search, k) => ({
      garment: k === 0 ? garment.name : `${garment.name} (seed ${k + 1})`,
      group: print.group,
      symmetry,
      starts,
      search,
    }));
  };
  const rows = await twoAtOnce(cases, async (one, number) => {
    const name = `search: ${one.garment.name}, ${one.print.group}, ${one.symmetry}`;
    const isLong = longOnes.has(number);
    say(isLong ? `${name}, long` : name);
    return unlessBroken(name, fail, () => measure(one, isLong));
  });
  return rows.filter(isThere).flat();
}

/** Picks `count` cases, spread over garments, prints and symmetries; or all cases. */
function spread(count, garments, prints) {
  const all = garments * prints * 2;
  const chosen = Array.from({length: Math.min(count, all)}, (_, k) =>
    count >= all
      ? k
      : (Math.floor((k * garments) / count) * prints + ((3 * k) % prints)) * 2 + (k % 2),
  );
  return new Set(chosen);
}

/** Measures one change to a solved problem, on meshes of 16.5k triangles, in WebAssembly. */
export async function measureEdits({programs, garments, prints, thorough, say, fail}) {
  const [print] = prints.methods;
  const rows = [];
  for (const garment of usualOf(garments, thorough)) {
    say(`edits: ${garment.name}`);
    const files = {garment, print};
    const measure = async () => {
      const {edgeLength} = await meshOf(programs, files, paperTriangles);
      const [factorisation, edit] = await programs.ask('wasm', [
        {...named('factorise', files), edgeLength, ...often},
        {...named('edit', files), edgeLength, ...often},
      ]);
      return {garment: garment.name, group: print.group, factorisation, edit};
    };
    rows.push(await unlessBroken(`edits: ${garment.name}`, fail, measure));
  }
  return rows.filter(isThere);
}

/**
 * Measures one garment in ever finer meshes. Each runs in its own process, so that it has its own
 * peak of memory.
 */
export async function measureGrowth({programs, garments, prints, say, fail}) {
  const garment = exampleOf(garments);
  const files = {garment, print: prints.methods[0]};
  const rows = [];
  for (const wanted of sizes) {
    const name = `growth: ${garment.name}, ${wanted / 1000}k`;
    say(name);
    const measure = async () => {
      const {edgeLength, triangles} = await meshOf(programs, files, wanted);
      const task = {...named('solve', files), edgeLength, ...often};
      return {garment: garment.name, edgeLength, triangles, ...(await programs.onBoth(task))};
    };
    rows.push(await unlessBroken(name, fail, measure));
  }
  const measured = rows.filter(isThere);
  const phases = ['prepare', 'alignment', 'deformation', 'total'];
  const exponents = Object.fromEntries(
    both.map((platform) => [
      platform,
      Object.fromEntries(phases.map((phase) => [phase, slope(measured, platform, phase)])),
    ]),
  );
  return {sizes: measured, exponents};
}

/**
 * Drapes every garment, and drapes it again in another print; times in factorisations of a grid.
 */
export async function measureDrapes({programs, garments, prints, say, fail}) {
  const rows = [];
  for (const garment of garments) {
    const name = `drapes: ${garment.name}`;
    say(name);
    const measure = async () => {
      const task = named('drape', {garment, print: prints.methods[0]});
      return {garment: garment.name, ...(await programs.onBoth(task))};
    };
    rows.push(await unlessBroken(name, fail, measure));
  }
  return rows.filter(isThere);
}

const slope = (rows, platform, phase) =>
  exponent(rows.map((row) => [row.triangles, row[platform].milliseconds[phase]]));
