// `npm run compare`: the method `best` against `paper`, on every garment with prints of several groups.
import {fork} from 'node:child_process';
import {fileURLToPath} from 'node:url';
import {parseArgs} from 'node:util';

import {build} from '../../web/setup/build.mjs';
import {main, say, SetupError} from '../../web/setup/shell.mjs';
import {findGarments, findPrints, usualGroups} from './cases.mjs';
import {compare, goals, summarise} from './comparison.mjs';

const usage = `npm run compare -- [--garments DIR ...] [--only GARMENT] [--groups ${usualGroups.join(',')}]
    [--seeds N] [--symmetry auto|none] [--jobs N] [--json]
Solves the sample garments, and all below the given folders, by the methods best and paper. Shows medians
over the seeds 1 to N (5), and their quotients: '=' where neither leaves a mismatch, * above the goal.
--only takes a part of a garment's name. Times are only to be trusted with one job (the default) on an idle machine.`;

function readArguments() {
  const text = {type: 'string'};
  const flag = {type: 'boolean', default: false};
  try {
    const {values, positionals} = parseArgs({
      allowPositionals: true,
      options: {
        garments: {...text, multiple: true, default: []},
        only: text,
        groups: {...text, default: usualGroups.join()},
        seeds: {...text, default: '5'},
        symmetry: {...text, default: 'auto'},
        jobs: {...text, default: '1'},
        json: flag,
        help: flag,
      },
    });
    if (positionals.length > 0 && values.garments.length === 0) {
      throw new SetupError(`'${positionals[0]}' is no option`);
    }
    return {...values, folders: [...values.garments, ...positionals]};
  } catch (error) {
    throw new SetupError(`${error.message}\n\n${usage}`);
  }
}

function count(name, value) {
  if (!/^[1-9]\d{0,3}$/.test(value)) {
    throw new SetupError(`--${name} is '${value}', but must be a whole number from 1 to 9999`);
  }
  return Number(value);
}

/** A process that solves one task at a time. */
class Worker {
  #process = fork(fileURLToPath(new URL('solve-case.mjs', import.meta.url)));
  #ready = this.#answer();

  #answer() {
    return new Promise((resolve, reject) => {
      const ended = (code) => reject(new SetupError(`a worker process ended with code ${code}`));
      this.#process.once('exit', ended);
      this.#process.once('message', (message) => {
        this.#process.off('exit', ended);
        resolve(message);
      });
    });
  }

  async solve(task) {
    await this.#ready;
    const answer = this.#answer();
    this.#process.send(task);
    return answer;
  }

  stop() {
    this.#process.removeAllListeners('exit');
    this.#process.kill();
  }
}

/** Solves all tasks, in their order, `jobs` at a time; `onDone` hears of each. */
async function solveAll(tasks, jobs, onDone) {
  const workers = Array.from({length: Math.min(jobs, tasks.length)}, () => new Worker());
  const queue = [...tasks];
  try {
    await Promise.all(
      workers.map(async (worker) => {
        for (let task = queue.shift(); task; task = queue.shift()) {
          onDone(task, await worker.solve(task));
        }
      }),
    );
  } finally {
    for (const worker of workers) worker.stop();
  }
}

const columns = [7, 9, 9, 8, 9, 9, 8, 9, 9];

function line(name, width, cells) {
  return [name.padEnd(width), ...cells.map((cell, k) => cell.padStart(columns[k]))].join(' ');
}

const number = (value, digits) => (Number.isFinite(value) ? value.toFixed(digits) : 'inf');

/** A quotient, with a star when it is above its goal. */
function quotient(ratios, key) {
  const value = ratios[key];
  if (value === '=') return '= ';
  const {goal} = goals.find((one) => one.key === key);
  return `${number(value, 3)}${value > goal ? '*' : ' '}`;
}

function row(width, {garment, group, best, paper, ratios}) {
  return line(garment, width, [
    group.padEnd(5),
    number(best.fit, 2),
    number(paper.fit, 2),
    quotient(ratios, 'fit'),
    number(best.milliseconds, 0),
    number(paper.milliseconds, 0),
    quotient(ratios, 'time'),
    quotient(ratios, 'random'),
    quotient(ratios, 'seamRandom'),
  ]);
}

function summaryLine({title, goal, median, met, worst, above, compared, equal}) {
  const verdict = met ? 'met' : 'MISSED';
  const extreme = worst
    ? `worst ${number(worst.value, 3)} (${worst.garment}, ${worst.group}), ${above} of ${compared} above`
    : 'nothing to compare';
  const same = equal > 0 ? `, ${equal} without mismatch` : '';
  return `${title.padEnd(16)} median ${number(median, 3)}, goal ${goal} ${verdict}; ${extreme}${same}`;
}

/** JSON knows no infinity and would write null. */
const infinite = (_, value) => (value === Infinity ? 'inf' : value);

async function run() {
  const options = readArguments();
  if (options.help) {
    console.log(usage);
    return;
  }
  const garments = findGarments(options.folders, options.only);
  const prints = findPrints(options.groups.split(','));
  const seeds = count('seeds', options.seeds);
  const jobs = count('jobs', options.jobs);
  await build();

  const write = options.json ? say : (text) => console.log(text);
  const width = Math.max(7, ...garments.map(({name}) => name.length));
  write(line('', width, ['', 'fit [cm2]', '', '', 'time [ms]', '', '', 'best fit', 'best seam']));
  write(
    line('garment', width, [
      'group',
      'best',
      'paper',
      'ratio ',
      'best',
      'paper',
      'ratio ',
      '/random ',
      '/random ',
    ]),
  );
  const cells = garments.flatMap(({name, file}) =>
    prints.map((print) => ({
      garment: name,
      group: print.group,
      files: [file, print.file],
      runs: [],
    })),
  );
  const tasks = cells.flatMap((cell) =>
    Array.from({length: seeds}, (_, k) => ({
      cell: cells.indexOf(cell),
      garment: cell.files[0],
      print: cell.files[1],
      symmetry: options.symmetry,
      seed: k + 1,
    })),
  );
  const comparisons = [];
  const failures = [];
  await solveAll(tasks, jobs, ({cell, seed}, answer) => {
    const {garment, group, runs} = cells[cell];
    runs.push({seed, ...answer});
    if (answer.failure) {
      failures.push({garment, group, seed, failure: answer.failure});
      write(`${garment} ${group} seed ${seed} FAILED: ${answer.failure}`);
    }
    const solved = runs.filter(({failure}) => !failure);
    if (runs.length < seeds || solved.length === 0) return;
    const comparison = {garment, group, ...compare(solved), runs: solved};
    comparisons.push(comparison);
    write(row(width, comparison));
  });
  const summary = summarise(comparisons);
  write('');
  for (const one of summary) write(summaryLine(one));
  if (failures.length > 0) write(`${failures.length} of ${tasks.length} cases failed`);
  if (options.json) console.log(JSON.stringify({summary, comparisons, failures}, infinite, 1));
  if (failures.length > 0) process.exitCode = 1;
}

await main(run);
