// `npm test`: installs and builds what is missing, then runs the checks of a commit, all of them
// even if one fails; those that passed on the same files before are left out. `npm test -- fast`
// takes less than two minutes, `npm test -- thorough` runs all checks, and `npm test -- native web`
// runs only the named ones, in any case.
import {checks, fast, ordinary, systemNeeds, thorough} from './checks.mjs';
import {countsIn} from './counts.mjs';
import {ensurePackages} from './packages.mjs';
import {beginReport, report, timesOf} from './report.mjs';
import {collected, main, say, SetupError} from './shell.mjs';
import {ensureSystem, installHeadlessShell} from './system.mjs';

/** Work that a run may do, counted; more of it makes a run slow on every machine. */
const budgets = {'browser start': 1, 'page build': 3, 'page solve': 450};

/** Runs a check, and prints its outcome. */
async function outcome(name, level) {
  const started = performance.now();
  let passed = false;
  say(`== ${name}`);
  try {
    passed = await checks[name].run(level);
  } catch (error) {
    if (!(error instanceof SetupError)) throw error;
    say(error.message);
  }
  const seconds = (performance.now() - started) / 1000;
  say(`== ${name} ${passed ? 'passed' : 'FAILED'} in ${seconds.toFixed(1)} s\n`);
  return {name, passed, seconds};
}

/** Runs checks two at a time, each after those whose products it needs. @returns their outcomes */
async function outcomes(names, level) {
  const waiting = [...names];
  const running = new Map();
  const ended = [];
  const isReady = (name) => {
    const {needs = [], after = [], isAlone} = checks[name];
    if (isAlone) return running.size === 0 && waiting.length === 1;
    return [...needs, ...after].every((other) => !waiting.includes(other) && !running.has(other));
  };
  while (waiting.length > 0 || running.size > 0) {
    const next = running.size < 2 ? waiting.find(isReady) : undefined;
    if (next === undefined) {
      ended.push(await Promise.race(running.values()));
      running.delete(ended.at(-1).name);
      continue;
    }
    waiting.splice(waiting.indexOf(next), 1);
    running.set(
      next,
      collected(() => outcome(next, level)),
    );
  }
  return ended;
}

/** The checks of a level, or the named ones, with those they need. */
function chosen(asked) {
  if (asked.length === 0) return ordinary;
  if (asked.includes('thorough')) return thorough;
  const names = asked.flatMap((name) => (name === 'fast' ? fast : [name]));
  const unknown = names.find((name) => !Object.hasOwn(checks, name));
  if (unknown) {
    const known = ['fast', 'thorough', ...Object.keys(checks)].join(', ');
    throw new SetupError(`no check '${unknown}'; there are ${known}`);
  }
  const withNeeds = (name) => [...(checks[name].needs ?? []).flatMap(withNeeds), name];
  return [...new Set(names.flatMap(withNeeds))];
}

await main(async () => {
  const asked = process.argv.slice(2);
  const names = chosen(asked);
  const isThorough = asked.includes('thorough');
  // All at once, so that a manual installation is requested only once.
  if (asked.length === 0 || isThorough) {
    await installHeadlessShell();
    await ensureSystem(systemNeeds);
  }
  await ensurePackages();
  beginReport();
  const counts = timesOf('counts.txt');
  process.env.SEAMWISE_COUNTS = counts;
  const level = isThorough ? 'thorough' : 'commit';
  const isNamed = asked.some((name) => name !== 'fast');
  const ended = await outcomes(names, {isThorough, isAnew: isNamed, level});
  const counted = countsIn(counts);
  report(ended, counted, budgets);
  const failed = ended.filter(({passed}) => !passed).map(({name}) => name);
  const over = Object.keys(budgets).filter((kind) => !isThorough && counted[kind] > budgets[kind]);
  if (over.length > 0) failed.push(`more than the budget: ${over.join(', ')}`);
  if (failed.length > 0) throw new SetupError(`\nfailed: ${failed.join(', ')}`);
  say('\nAll checks passed.');
});
