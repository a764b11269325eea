// Quotients by which the solver is judged: their source, their goal, and whether they meet it.

import {median, quotient} from './numbers.mjs';

/** Mismatches that differ by less are equal: a tenth of a per cent, about where iterations stop. */
const same = 1e-3;
/** parts.mjs, which makes the rows of a part, documents their fields. */
const searches = (results) => results.search ?? [];
const longSearches = (results) => searches(results).filter(({search}) => search.longFit >= 0);
/** Rows in which all of these methods were measured. */
const methods = (results, ...wanted) =>
  (results.methods ?? []).filter((row) => wanted.every((method) => row[method]));
/** Rows of the comparison with the published method in which all were measured. */
const published = (results) =>
  (results.published ?? []).filter(({best, paper, bestPaper}) => best && paper && bestPaper);
const meshes = (results) => results.yardstick ?? [];
const edits = (results) => results.edits ?? [];
const changes = (results, wanted) =>
  edits(results).flatMap(({garment, edit, factorisation}) =>
    Object.entries(edit.changes)
      .filter(([name]) => wanted(name))
      .map(([name, change]) => ({name: `${garment}, ${name}`, change, factorisation})),
  );
const isSymmetry = (name) => name.startsWith('symmetry');
const mostPieces = 8;

const caseName = ({garment, group, symmetry}) =>
  [garment, group, symmetry].filter(Boolean).join(', ');
const each = (rows, value) => rows.map((row) => ({name: caseName(row), value: value(row)}));

/**
 * All quotients. `values` returns them by case, `over` is the one that counts ('median' or
 * 'worst'), `goal` is the upper limit and `aim` the value worth reaching.
 */
const quotients = [
  {
    title: 'fitSearch / best of 1000 random starts',
    over: 'worst',
    goal: 1 + same,
    aim: 1 + same,
    values: (r) => each(searches(r), (row) => quotient(row.search.fitSearch, row.starts.best)),
  },
  {
    title: 'fitSearch / best of 1000 random starts',
    over: 'median',
    goal: 0.85,
    aim: 0.8,
    values: (r) => each(searches(r), (row) => quotient(row.search.fitSearch, row.starts.best)),
  },
  {
    title: 'fitSearch / fit of the long search',
    over: 'median',
    goal: 1 + same,
    aim: 1 + same,
    values: (r) => each(longSearches(r), ({search}) => quotient(search.fitSearch, search.longFit)),
  },
  {
    title: 'fitSearch / fit of the long search',
    over: 'worst',
    goal: 1.05,
    aim: 1.01,
    values: (r) => each(longSearches(r), ({search}) => quotient(search.fitSearch, search.longFit)),
  },
  {
    title: 'search time / time of 1000 random starts',
    over: 'median',
    goal: 0.3,
    aim: 0.05,
    values: (r) => each(searches(r), (row) => row.search.milliseconds / row.starts.milliseconds),
  },
  {
    title: 'fit best / paper as published',
    over: 'median',
    goal: 0.4,
    aim: 0.2,
    values: (r) => each(published(r), ({best, paper}) => quotient(best.fit, paper.fit)),
  },
  {
    title: 'fit best / best paper',
    over: 'median',
    goal: 0.5,
    aim: 0.4,
    values: (r) => each(published(r), ({best, bestPaper}) => quotient(best.fit, bestPaper.fit)),
  },
  {
    title: 'fit best / best paper',
    over: 'worst',
    goal: 1 + same,
    aim: 1 + same,
    values: (r) => each(published(r), ({best, bestPaper}) => quotient(best.fit, bestPaper.fit)),
  },
  {
    title: 'fit / fitRandom',
    over: 'median',
    goal: 0.07,
    aim: 0.05,
    values: (r) => each(methods(r, 'best'), ({best: {native}}) => native.fit / native.fitRandom),
  },
  {
    title: 'fit / fitDrafted',
    over: 'median',
    goal: 0.14,
    aim: 0.1,
    values: (r) => each(methods(r, 'best'), ({best: {native}}) => native.fit / native.fitDrafted),
  },
  {
    title: 'fitSeam / fitSeamRandom',
    over: 'median',
    goal: 0.07,
    aim: 0.05,
    values: (r) =>
      each(methods(r, 'best'), ({best: {native}}) => native.fitSeam / native.fitSeamRandom),
  },
  {
    title: 'time best / paper, 16.5k triangles',
    over: 'median',
    goal: 1 / 30,
    aim: 1 / 100,
    values: (r) =>
      each(
        meshes(r).filter(({paper}) => paper),
        (row) => row.best.native.milliseconds.total / row.paper.native.milliseconds.total,
      ),
  },
  {
    title: 'deformation of best / one factorisation, 16.5k triangles, wasm',
    over: 'median',
    goal: 20,
    aim: 8,
    values: (r) =>
      each(
        meshes(r),
        ({best, factorisation}) => best.wasm.milliseconds.deformation / factorisation.wasm.numeric,
      ),
  },
  {
    title: `whole best solve, up to ${mostPieces} free pieces / one factorisation, wasm`,
    over: 'median',
    goal: 40,
    aim: 15,
    values: (r) =>
      each(
        meshes(r).filter(({best}) => best.wasm.freePieces <= mostPieces),
        (row) => row.best.wasm.milliseconds.total / row.factorisation.wasm.numeric,
      ),
  },
  {
    title: 'first answer after one change / one factorisation, wasm',
    over: 'median',
    goal: 4,
    aim: 1,
    values: (r) =>
      changes(r, (name) => !isSymmetry(name)).map(({name, change, factorisation}) => ({
        name,
        value: change.first / factorisation.numeric,
      })),
  },
  {
    title: 'final answer after one change / one factorisation, wasm',
    over: 'median',
    goal: 15,
    aim: 5,
    values: (r) =>
      changes(r, (name) => !isSymmetry(name)).map(({name, change, factorisation}) => ({
        name,
        value: change.final / factorisation.numeric,
      })),
  },
  {
    title: 'final answer after symmetry is added or removed / one factorisation, wasm',
    over: 'median',
    goal: 15,
    aim: 5,
    values: (r) =>
      changes(r, isSymmetry).map(({name, change, factorisation}) => ({
        name,
        value: change.final / factorisation.numeric,
      })),
  },
  {
    title: 'deformation time with / without symmetry',
    over: 'median',
    goal: 1,
    aim: 0.6,
    values: (r) =>
      each(
        methods(r, 'best', 'none').filter(({best}) => best.native.symmetries > 0),
        ({best, none}) =>
          best.native.milliseconds.deformation / none.native.milliseconds.deformation,
      ),
  },
  {
    title: 'whole solve, wasm / native',
    over: 'median',
    goal: 1.5,
    aim: 1.15,
    values: (r) =>
      each(
        methods(r, 'best'),
        ({best: {native, wasm}}) => wasm.milliseconds.total / native.milliseconds.total,
      ),
  },
  {
    title: 'exponent of time over triangles',
    over: 'worst',
    goal: 1.35,
    aim: 1.15,
    values: (r) =>
      Object.entries(r.growth?.exponents ?? {})
        .filter(([, of]) => of.total)
        .map(([name, of]) => ({name, value: of.total})),
  },
  {
    title: 'peak memory at 160k triangles [MB]',
    over: 'worst',
    goal: 300,
    aim: 150,
    values: (r) =>
      (r.growth?.sizes ?? [])
        .filter(({triangles}) => triangles > 140e3)
        .flatMap(({native, wasm}) => [
          {name: 'native', value: native.peakMemory / 1e6},
          {name: 'wasm', value: wasm.peakMemory / 1e6},
        ]),
  },
  {
    title: 'first alignment that can be drawn, wasm [ms]',
    over: 'worst',
    goal: 50,
    aim: 50,
    values: (r) => each(methods(r, 'best'), ({best}) => best.wasm.firstAlignment),
  },
  {
    title: 'distance of the progress from the share of time, wasm',
    over: 'worst',
    goal: 0.2,
    aim: 0.2,
    values: (r) =>
      each(methods(r, 'best'), ({best: {wasm}}) =>
        wasm.progress.monotone ? wasm.progress.astray : Infinity,
      ),
  },
];

/**
 * Summarises every measured quotient: the value that counts, whether it meets its goal and its aim,
 * the worst case, and the number of cases that miss the goal. Cases without any mismatch are left
 * out.
 */
export function ratiosOf(results) {
  return quotients.flatMap(({title, over, goal, aim, values}) => {
    const numbers = values(results).filter(({value}) => value !== null && !Number.isNaN(value));
    return numbers.length > 0 ? [summary(title, over, goal, aim, numbers)] : [];
  });
}

export function summary(title, over, goal, aim, numbers) {
  const worst = numbers.reduce((a, b) => (b.value > a.value ? b : a));
  const value = over === 'worst' ? worst.value : median(numbers.map((number) => number.value));
  return {
    title,
    over,
    value,
    goal,
    aim,
    met: value <= goal,
    reached: value <= aim,
    worst,
    missed: numbers.filter((number) => number.value > goal).length,
    cases: numbers.length,
  };
}
