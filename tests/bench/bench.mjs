// `npm run bench`: measures the solver's results, time and memory natively, in WebAssembly and in
// the page.
import {execFileSync} from 'node:child_process';
import {writeFileSync} from 'node:fs';
import {cpus, release, type} from 'node:os';
import {join} from 'node:path';
import {parseArgs} from 'node:util';

import {build, buildBench} from '../../web/setup/build.mjs';
import {ensurePackages} from '../../web/setup/packages.mjs';
import {main, root, say, SetupError} from '../../web/setup/shell.mjs';
import {findGarments, findPrints} from './cases.mjs';
import {measureLayouts} from './layouts.mjs';
import {
  both,
  measureDrapes,
  measureEdits,
  measureGrowth,
  measureMethods,
  measurePublished,
  measureSearch,
  measureYardstick,
} from './parts.mjs';
import {Programs} from './program.mjs';
import {ratiosOf} from './ratios.mjs';
import {measureRules} from './rules.mjs';
import {tablesOf} from './tables.mjs';

/** Parts that can be measured separately, and the benchmark programs each of them runs. */
const parts = {
  methods: {measure: measureMethods, platforms: both},
  published: {measure: measurePublished, platforms: ['native']},
  yardstick: {measure: measureYardstick, platforms: both},
  search: {measure: measureSearch, platforms: ['native']},
  edits: {measure: measureEdits, platforms: both},
  growth: {measure: measureGrowth, platforms: both},
  drapes: {measure: measureDrapes, platforms: both},
  layouts: {measure: measureLayouts, platforms: both},
  rules: {measure: measureRules, platforms: []},
  page: {
    measure: async (settings) => (await import('./page.mjs')).measurePage(settings),
    platforms: [],
  },
};
const usualGroups = ['pmm', 'p4m', 'pgg', 'cm', 'p31m', 'p6m', 'p1'];
const usualLongCases = 10;

const usage = `npm run bench -- [--parts ${Object.keys(parts).join(',')}] [--garments DIR ...] [--only NAME]
    [--groups GROUP,...] [--seeds N] [--long SECONDS] [--long-cases N] [--thorough] [--json] [--write]
Measures the sample garments, and all below the given folders, on an idle machine; about three
quarters of an hour: half of it 'published', a minute or less 'growth', 'edits', 'drapes' and 'page', the others some minutes each.
'layouts' lays the pieces of tee, shirt, trousers, princess dress and hoodie on cloth with prints that repeat every 10 and 20 cm, and without.
--only takes a part of a garment's name. --groups are those of the prints: of 'methods' (pmm by itself), of
'published' and of 'search' (${usualGroups.join()} by themselves). --seeds: of paper and ws19, of the search, and of the layouts (1).
--long: how much time the search gets for comparison (60 s), in so many cases (${usualLongCases}).
--thorough solves paper and ws19 with five seeds and in WebAssembly, too, compares every garment with
the published method in every group, gives every search the long time,
lays the pieces of all garments, and counts broken rules in every size; that takes hours. --json writes everything for machines (npm run -s bench: npm itself is silent, too), --write the
tables into docs/benchmarks.md.`;

function readArguments() {
  const text = {type: 'string'};
  const flag = {type: 'boolean', default: false};
  try {
    const {values} = parseArgs({
      options: {
        parts: {...text, default: Object.keys(parts).join()},
        garments: {...text, multiple: true, default: []},
        only: text,
        groups: text,
        seeds: text,
        long: {...text, default: '60'},
        'long-cases': text,
        thorough: flag,
        json: flag,
        write: flag,
        help: flag,
      },
    });
    return values;
  } catch (error) {
    throw new SetupError(`${error.message}\n\n${usage}`);
  }
}

function count(name, value) {
  if (!/^\d{1,5}$/.test(value))
    throw new SetupError(`--${name} is '${value}', but must be a number`);
  return Number(value);
}

function chosenParts(text) {
  const names = text.split(',');
  const unknown = names.find((name) => !Object.hasOwn(parts, name));
  if (unknown !== undefined) {
    throw new SetupError(`no part '${unknown}'; there are ${Object.keys(parts).join(', ')}`);
  }
  return Object.keys(parts).filter((name) => names.includes(name));
}

const git = (...words) =>
  execFileSync('git', words, {cwd: root, stdio: ['ignore', 'pipe', 'ignore']})
    .toString()
    .trim();

/** Date, machine and versions of the measurement. */
function circumstances() {
  const [processor] = cpus();
  // the path of a folder on this machine means nothing elsewhere
  const words = process.argv
    .slice(2)
    .map((word, k, all) => (all[k - 1] === '--garments' ? 'DIR' : word));
  return {
    date: new Date().toISOString().slice(0, 10),
    machine: `${processor?.model ?? 'unknown'}, ${cpus().length} cores, ${type()} ${release()}`,
    node: process.version,
    commit: commit(),
    command: ['npm run bench', ...(words.length > 0 ? ['--', ...words] : [])].join(' '),
  };
}

function commit() {
  try {
    return `${git('rev-parse', '--short', 'HEAD')}${git('status', '--porcelain') ? ', changed' : ''}`;
  } catch {
    return 'unknown';
  }
}

/** JSON has no infinity and would write null. */
const infinite = (_, value) => (value === Infinity ? 'inf' : value);

function page({date, machine, node, commit: of, command, minutes, ...results}) {
  return `# Benchmarks

Written by \`${command}\` on ${date}, in ${minutes} minutes, on ${machine}, Node ${node}, at commit ${of}.
\`npm run bench -- --help\` lists the options. Fits are in cm², times in milliseconds. A short time is the quickest of several runs.
\`native\` and \`wasm\` are the same program around the same core. \`wasm\` runs in Node, compiled as the page's module is.

${notes}
${tablesOf(results)}`;
}

const notes = `- **fit** and the related figures are those of [the result](formats.md#figures). *free* pieces are those with an alignment of their own.
  *random* is the mean over random alignments; *fit/random* and *seam/random* compare with it. *first ms*: time from the files to the
  first alignment that can be drawn, in the first solve of a process after the small warm-up solves of a page's worker. *progress off*: the
  greatest difference between the reported progress and the share of time spent. *memory*: the greatest memory in use, beyond that of the
  program before.
  *fit/drafted* compares with the drafted pieces placed on grain. *off*: length of seam with a mismatch above 5 mm. Nine tenths of the
  seam length have a mismatch of at most *p90*.
- **paper** and **ws19** are timed by their last attempt: they are solved with growing stiffness until the greatest change holds. Under
  *Methods*, two of them run at once.
- **Against the published method**: every garment in three of the groups in turn, two cases at once. *paper*: as published, with one
  random start. *best paper*: the best end of 50 starts and one from the drafted layout, then deformed towards its targets, unchanged or
  clipped to 0.9 of the greatest change, whichever fits better. Neither ends worse than undeformed.
- **Search**: 1000 starts at random alignments, each improved by the local step of \`best\`, the best ten of them on every edge.
  \`fitSearch\` is that of the default budget; its time is that of the whole alignment phase. *bound*: no alignment costs less than this
  share of it. The long search continues from there with a budget of that many seconds. All seams have equal weight, and marked lines are
  left out, so that the fit is the cost of the search. Two cases run at once, but both times of a ratio come from the same process.
- **One factorisation**: the LDLT factorisation (numerical part, by the core's own factoriser) of the Hessian of the whole, unreduced
  mesh: two unknowns for every vertex of every piece, conformal energy and a pull to rest.
- **Edits**: as in a worker, which reuses mesh and searches of the previous answer as far as the change leaves them valid. The answer is
  the same as without them.
- **Rules**: all sample prints, on grain and at any angle. *worse*: seams whose mean mismatch is more than 0.3 mm above that of placing
  alone and above 1 mm. *in vain*: seams that shaping improves by less than a quarter although a vertex off its ends moves by more than
  1 mm. *whole*: results above the drafted pieces placed on grain. Means over all prints, in mm.
- **Layouts**: cut lines with 1 cm allowance on fabric of 140 cm, at random alignments on grain, in a square cell of group p2. *area*: area
  of all pieces over the width. *bound*: no layout is shorter than this, with *proven* if one is as long. *no print*: the same pieces
  without the print. Times from the outlines to the first layout, and to the end of search and proof.
- \`=\` marks two fits without any mismatch.
`;

async function run() {
  const options = readArguments();
  if (options.help) {
    console.log(usage);
    return;
  }
  const started = performance.now();
  const failures = [];
  const fail = (text) => {
    failures.push(text);
    say(`FAILED: ${text}`);
  };
  const groups = (usual) => findPrints(options.groups?.split(',') ?? usual);
  const settings = {
    garments: findGarments(options.garments, options.only),
    prints: {
      methods: groups(['pmm']),
      published: groups(usualGroups),
      search: groups(usualGroups),
      layouts: findPrints(['p2']),
    },
    seeds: count('seeds', options.seeds ?? (options.thorough ? '5' : '1')),
    long: count('long', options.long),
    longCases: count(
      'long-cases',
      options['long-cases'] ?? (options.thorough ? '99999' : String(usualLongCases)),
    ),
    thorough: options.thorough,
    say,
    fail,
  };
  const names = chosenParts(options.parts);
  await ensurePackages();
  const platforms = both.filter((platform) =>
    names.some((name) => parts[name].platforms.includes(platform)),
  );
  await build('scripts');
  const {warmUpProblems} = await import('../../dist/solver/warm-up.js');
  settings.programs = new Programs(await buildBench(platforms), warmUpProblems);
  const results = circumstances();
  for (const name of names) {
    try {
      results[name] = await parts[name].measure(settings);
    } catch (error) {
      fail(`${name}: ${error.message}`); // minutes of measurements must not be lost
    }
  }
  results.failures = failures;
  results.minutes = Math.round((performance.now() - started) / 60_000);
  results.ratios = ratiosOf(results);
  if (options.write) writeFileSync(join(root, 'docs/benchmarks.md'), page(results));
  console.log(options.json ? JSON.stringify(results, infinite, 1) : tablesOf(results));
  if (failures.length > 0) process.exitCode = 1;
}

await main(run);
