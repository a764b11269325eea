// The figures as tables, in Markdown that is readable as plain text.
import {layoutTable} from './layout-table.mjs';
import {quotient} from './numbers.mjs';
import {publishedTables} from './published-tables.mjs';
import {digits, fit, kilobytes, megabytes, millimetres, ms, share, table} from './table.mjs';

const methodNames = ['ws19', 'paper', 'none', 'best'];
const shown = {none: 'best, no symmetry'};
const measuredBy = (row) => methodNames.filter((method) => row[method]);

/** Rows of a case: the mean over random alignments, then results and times of the methods. */
function methodRows({garment, group, ...row}) {
  const lines = [];
  for (const method of measuredBy(row)) {
    for (const platform of ['native', 'wasm']) {
      const figures = row[method][platform];
      if (!figures) continue;
      const {milliseconds: spent} = figures;
      if (lines.length === 0) lines.push(...comparedRows(`${garment}, ${group}`, figures));
      lines.push([
        '',
        `${shown[method] ?? method}, ${platform}`,
        figures.pieces,
        figures.freePieces,
        figures.triangles,
        fit(figures.fitSearch),
        fit(figures.fitAligned),
        fit(figures.fit),
        fit(figures.fitSeam),
        share(figures.fit / figures.fitRandom),
        share(figures.fit / figures.fitDrafted),
        share(figures.fitSeam / figures.fitSeamRandom),
        figures.off.toFixed(0),
        millimetres(figures.p90),
        figures.iterations,
        figures.factorisations,
        ms(spent.prepare),
        ms(spent.alignment),
        ms(spent.deformation),
        ms(spent.total),
        ms(figures.firstAlignment),
        figures.progress.monotone ? figures.progress.astray.toFixed(2) : 'falls',
        megabytes(figures.peakMemory),
      ]);
    }
  }
  return lines;
}

/** Mismatches for comparison: random alignments and the drafted garment. */
function comparedRows(name, {pieces, triangles, fitRandom, fitSeamRandom, fitDrafted}) {
  const rows = [
    {method: 'random', pieces, triangles, fit: fit(fitRandom), fitSeam: fit(fitSeamRandom)},
    {method: 'drafted', fit: fit(fitDrafted)},
  ];
  return rows.map((cells, k) =>
    methodHead.map((title) =>
      title === 'garment, group' && k === 0 ? name : (cells[title] ?? ''),
    ),
  );
}

const methodHead = [
  'garment, group',
  'method',
  'pieces',
  'free',
  'triangles',
  'fitSearch',
  'fitAligned',
  'fit',
  'fitSeam',
  'fit/random',
  'fit/drafted',
  'seam/random',
  'off cm',
  'p90 mm',
  'iterations',
  'factorisations',
  'prepare',
  'alignment',
  'deformation',
  'total ms',
  'first ms',
  'progress off',
  'memory MB',
];

function searchRows(rows) {
  return rows.map(({garment, group, symmetry, starts, search}) => [
    `${garment}, ${group}, ${symmetry}`,
    fit(starts.median),
    fit(starts.best),
    fit(search.fitSearch),
    share(quotient(search.fitSearch, starts.best)),
    ms(starts.milliseconds),
    ms(search.milliseconds),
    share(search.milliseconds / starts.milliseconds),
    search.bound === 1 ? 'proven' : share(search.bound),
    ...(search.longFit >= 0
      ? [
          fit(search.longFit),
          share(quotient(search.fitSearch, search.longFit)),
          (search.longMilliseconds / 1000).toFixed(0),
        ]
      : ['', '', '']),
  ]);
}

const searchHead = [
  'garment, group, symmetry',
  'median of starts',
  'best of starts',
  'fitSearch',
  'ratio',
  'starts ms',
  'search ms',
  'ratio',
  'bound',
  'long fit',
  'ratio',
  'long s',
];

function yardstickRows(rows) {
  return rows.flatMap(({garment, triangles, factorisation, best}) =>
    ['native', 'wasm'].map((platform, k) => {
      const {symbolic, numeric, unknowns} = factorisation[platform];
      const {milliseconds: spent, factorisations, freePieces} = best[platform];
      return [
        k === 0 ? garment : '',
        platform,
        triangles,
        unknowns,
        freePieces,
        ms(symbolic),
        numeric.toFixed(2),
        factorisations,
        ms(spent.prepare),
        ms(spent.alignment),
        ms(spent.deformation),
        ms(spent.total),
        share(spent.deformation / numeric),
        share(spent.total / numeric),
      ];
    }),
  );
}

const yardstickHead = [
  'garment',
  'platform',
  'triangles',
  'unknowns',
  'free pieces',
  'symbolic ms',
  'numeric ms',
  'factorisations of best',
  'prepare',
  'alignment',
  'deformation',
  'total ms',
  'deformation/numeric',
  'total/numeric',
];

function editRows(rows) {
  return rows.flatMap(({garment, edit, factorisation}) =>
    Object.entries(edit.changes).map(([name, change], k) => [
      k === 0 ? garment : '',
      name,
      ms(change.first),
      fit(change.firstFit),
      ms(change.final),
      fit(change.fit),
      share(change.first / factorisation.numeric),
      share(change.final / factorisation.numeric),
    ]),
  );
}

const editHead = [
  'garment',
  'change',
  'first ms',
  'its fit',
  'final ms',
  'its fit',
  'first/factorisation',
  'final/factorisation',
];

function growthRows({sizes, exponents}) {
  const phases = ['prepare', 'alignment', 'deformation', 'total'];
  const rows = sizes.flatMap(({triangles, edgeLength, ...by}) =>
    ['native', 'wasm'].map((platform, k) => [
      k === 0 ? triangles : '',
      platform,
      edgeLength.toFixed(3),
      ...phases.map((phase) => ms(by[platform].milliseconds[phase])),
      megabytes(by[platform].peakMemory),
    ]),
  );
  const slopes = ['native', 'wasm'].map((platform) => [
    'exponent',
    platform,
    '',
    ...phases.map((phase) => exponents[platform][phase].toFixed(2)),
    '',
  ]);
  return [...rows, ...slopes];
}

function drapeRows(rows) {
  return rows.flatMap(({garment, native, wasm}) =>
    [native, wasm].map((figures, k) => [
      k === 0 ? garment : '',
      k === 0 ? 'native' : figures.hash === native.hash ? 'wasm, same bytes' : 'wasm, OTHER BYTES',
      figures.triangles,
      figures.unit.toFixed(1),
      figures.first.toFixed(1),
      figures.settled.toFixed(1),
      figures.counted.toFixed(1),
      figures.again.toFixed(1),
      ms(figures.milliseconds.first),
      ms(figures.milliseconds.settled),
      ms(figures.milliseconds.again),
      ...['median', 'p99', 'max'].map((name) => share(figures.tension[name])),
      figures.crossings,
    ]),
  );
}

const drapeHead = [
  'garment',
  'platform',
  'triangles',
  'one factorisation, ms',
  'first shape',
  'settled',
  'counted',
  'another print',
  'first, ms',
  'settled, ms',
  'another, ms',
  'tension, median',
  'p99',
  'max',
  'crossings',
];

const growthHead = [
  'triangles',
  'platform',
  'edge cm',
  'prepare',
  'alignment',
  'deformation',
  'total ms',
  'memory MB',
];

const pageRows = ({code, drawingLibrary, pdfReader, wasm, opening}) => [
  ['initial code, gzipped', `${kilobytes(code)} kB`],
  ['drawing library, gzipped', `${kilobytes(drawingLibrary)} kB`],
  ['reader of PDF, gzipped', `${kilobytes(pdfReader)} kB`],
  ['wasm, gzipped', `${kilobytes(wasm)} kB`],
  ['cold opening to the final answer', `${ms(opening)} ms`],
];

const rulesHead = [
  'garment',
  'grain',
  'cases',
  'seams',
  'worse',
  'in vain',
  'whole',
  'drafted mm',
  'placed mm',
  'final mm',
];

const rulesRow = ({garment, grain, cases, seams, worse, vain, whole, ...means}) => [
  garment,
  grain,
  cases,
  seams,
  worse,
  vain,
  whole,
  ...[means.drafted, means.placed, means.final].map((cm) => fit((10 * cm) / Math.max(cases, 1))),
];

export const ratioTable = (ratios) =>
  table(
    ['ratio', 'of cases', 'value', 'goal', '', 'aim', '', 'cases', 'above goal', 'worst case'],
    ratios.map(({title, over, value, goal, aim, met, reached, cases, missed, worst}) => [
      title,
      over,
      digits(value),
      goalText(goal),
      met ? 'met' : 'MISSED',
      goalText(aim),
      reached ? 'reached' : 'not yet',
      cases,
      missed,
      `${digits(worst.value)} (${worst.name})`,
    ]),
  );

const goalText = (value) => String(Number(value.toFixed(3)));

/** All measured parts, each under its own heading. */
export function tablesOf(results) {
  const parts = [
    ['Ratios', results.ratios.length > 0 && ratioTable(results.ratios)],
    ['Methods', results.methods && table(methodHead, results.methods.flatMap(methodRows))],
    ['Against the published method', results.published && publishedTables(results.published)],
    ['Search', results.search && table(searchHead, searchRows(results.search))],
    [
      'One factorisation as a yardstick',
      results.yardstick && table(yardstickHead, yardstickRows(results.yardstick)),
    ],
    ['Edits', results.edits && table(editHead, editRows(results.edits))],
    ['Rules', results.rules && table(rulesHead, results.rules.map(rulesRow))],
    ['Growth', results.growth && table(growthHead, growthRows(results.growth))],
    [
      'Drapes, in factorisations of a grid of 90 x 90 nodes',
      results.drapes && table(drapeHead, drapeRows(results.drapes)),
    ],
    [
      'Layouts, in factorisations of a grid of 90 x 90 nodes',
      results.layouts && layoutTable(results.layouts),
    ],
    ['Page', results.page && table(['', ''], pageRows(results.page))],
  ];
  if (results.failures.length > 0)
    parts.push(['Failures', results.failures.map((text) => `- ${text}`).join('\n')]);
  return parts
    .filter(([, text]) => text)
    .map(([title, text]) => `## ${title}\n\n${text}\n`)
    .join('\n');
}
