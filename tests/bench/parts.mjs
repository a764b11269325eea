// What is measured, part by part. Every part gives rows of figures, as the program answers them.
import {exponent} from './ratios.mjs';

/** Repeated within one process, the quickest counts. */
const often = {times: 3, atLeast: 1000};
/** Of the paper's largest garment, and those over which growth is measured. */
const paperTriangles = 16500;
const sizes = [5e3, 20e3, 80e3, 160e3];

const named = (task, {garment, print}) => ({task, garment: garment.file, print: print.file});

/** The row, unless something in it went wrong. */
function checked(row, fail) {
  const failures = [];
  JSON.stringify(row, (key, value) => {
    if (key === 'failure') failures.push(value);
    return value;
  });
  if (failures.length === 0) return [row];
  fail(`${row.garment}: ${failures[0]}`);
  return [];
}

/**
 * Every garment by every method. best and its solve without symmetry run natively and in
 * WebAssembly; paper and ws19, which take long, natively, and both ways when thorough.
 */
export async function measureMethods({programs, garments, prints, seeds, thorough, say, fail}) {
  const rows = [];
  for (const garment of garments) {
    for (const print of prints.methods) {
      say(`methods: ${garment.name}, ${print.group}`);
      const task = named('solve', {garment, print});
      const slow = async (method) => ({
        native: await medianOfSeeds(programs, 'native', {...task, method}, seeds),
        ...(thorough && {wasm: await medianOfSeeds(programs, 'wasm', {...task, method}, seeds)}),
      });
      const row = {
        garment: garment.name,
        group: print.group,
        best: await programs.onBoth({...task, ...often}),
        none: await programs.onBoth({...task, ...often, symmetry: 'none'}),
        ws19: await slow('ws19'),
        paper: await slow('paper'),
      };
      rows.push(...checked(row, fail));
    }
  }
  return rows;
}

/** The answer of the seed whose fit is the median's, the lower one of two. */
async function medianOfSeeds(programs, platform, task, seeds) {
  const tasks = Array.from({length: seeds}, (_, k) => ({...task, seed: k + 1}));
  const answers = await programs.ask(platform, tasks);
  const sorted = answers.toSorted((a, b) => a.fit - b.fit);
  return sorted[Math.floor((sorted.length - 1) / 2)];
}

/** Meshes of 16.5k triangles: one factorisation of the whole, and what solves take. */
export async function measureYardstick({programs, garments, prints, thorough, say, fail}) {
  const rows = [];
  for (const garment of garments) {
    for (const print of prints.methods.slice(0, 1)) {
      say(`yardstick: ${garment.name}`);
      const files = {garment, print};
      const mesh = await meshOf(programs, files, paperTriangles);
      const {edgeLength} = mesh;
      const row = {
        garment: garment.name,
        triangles: mesh.triangles,
        factorisation: await programs.onBoth({...named('factorise', files), edgeLength, times: 9}),
        best: await programs.onBoth({...named('solve', files), edgeLength, ...often}),
      };
      if (thorough || garment.name.startsWith('princess-dress')) {
        const task = {...named('solve', files), edgeLength, method: 'paper'};
        row.paper = {native: (await programs.ask('native', [task]))[0]};
      }
      rows.push(...checked(row, fail));
    }
  }
  return rows;
}

async function meshOf(programs, files, triangles) {
  const [mesh] = await programs.ask('native', [{...named('mesh', files), triangles}]);
  return mesh;
}

/**
 * The search against 1000 random starts, and, in `longCases` of the cases, against itself with
 * much more time. Seams weigh alike here, so that the fit is what is searched for.
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
  const rows = [];
  for (const [number, {garment, print, symmetry}] of cases.entries()) {
    const isLong = longOnes.has(number);
    say(`search: ${garment.name}, ${print.group}, ${symmetry}${isLong ? ', long' : ''}`);
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
    for (const [k, search] of found.entries()) {
      const name = k === 0 ? garment.name : `${garment.name} (seed ${k + 1})`;
      rows.push(...checked({garment: name, group: print.group, symmetry, starts, search}, fail));
    }
  }
  return rows;
}

/** The numbers of so many cases, of garments, prints and symmetries all over; or of all cases. */
function spread(count, garments, prints) {
  const all = garments * prints * 2;
  const chosen = Array.from({length: Math.min(count, all)}, (_, k) =>
    count >= all
      ? k
      : (Math.floor((k * garments) / count) * prints + ((3 * k) % prints)) * 2 + (k % 2),
  );
  return new Set(chosen);
}

/** One change to a solved problem, on meshes of 16.5k triangles, in WebAssembly. */
export async function measureEdits({programs, garments, prints, thorough, say, fail}) {
  const usual = ['princess-dress', 'shirt', 'trousers'];
  const chosen = garments.filter(
    ({name}) => thorough || usual.some((one) => name.startsWith(`${one}-`)),
  );
  const [print] = prints.methods;
  const rows = [];
  for (const garment of chosen.length > 0 ? chosen : garments.slice(0, 1)) {
    say(`edits: ${garment.name}`);
    const files = {garment, print};
    const {edgeLength} = await meshOf(programs, files, paperTriangles);
    const [factorisation, edit] = await programs.ask('wasm', [
      {...named('factorise', files), edgeLength, times: 9},
      {...named('edit', files), edgeLength, ...often},
    ]);
    rows.push(...checked({garment: garment.name, group: print.group, factorisation, edit}, fail));
  }
  return rows;
}

/** One garment in ever finer meshes. A process each, so that each has its own peak of memory. */
export async function measureGrowth({programs, garments, prints, say, fail}) {
  const garment = garments.find(({name}) => name.startsWith('princess-dress')) ?? garments[0];
  const files = {garment, print: prints.methods[0]};
  const rows = [];
  for (const wanted of sizes) {
    say(`growth: ${garment.name}, ${wanted / 1000}k`);
    const {edgeLength} = await meshOf(programs, files, wanted);
    const task = {...named('solve', files), edgeLength, ...often};
    const {native, wasm} = await programs.onBoth(task);
    rows.push(
      ...checked(
        {garment: garment.name, edgeLength, triangles: native.triangles, native, wasm},
        fail,
      ),
    );
  }
  const phases = ['prepare', 'alignment', 'deformation', 'total'];
  const exponents = Object.fromEntries(
    ['native', 'wasm'].map((platform) => [
      platform,
      Object.fromEntries(phases.map((phase) => [phase, slope(rows, platform, phase)])),
    ]),
  );
  return {sizes: rows, exponents};
}

const slope = (rows, platform, phase) =>
  exponent(rows.map((row) => [row.triangles, row[platform].milliseconds[phase]]));
