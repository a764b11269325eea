import {readFileSync, appendFileSync} from 'node:fs';
import {marker, SolverError, type SolveResult} from 'seamwise/node';
import {it} from 'vitest';
import {groupNames} from '@/model/print.js';
import {planComplaints} from '../support/check-plan.js';
import {at} from '../support/plane.js';
import {chance, randomLay} from '../support/random-lay.js';
const garments = ['apron','asymmetric-dress','gathered-skirt','hoodie','patchwork-jacket','princess-dress','raglan','shift-dress','shirt','six-gore-skirt','tee','trousers'];
const part = Number(process.env['PART'] ?? 0), parts = Number(process.env['PARTS'] ?? 1);
it('sweeps', {timeout: 1e8}, async () => {
  const read = (g: string, p: string) => ({...JSON.parse(readFileSync(`/tmp/rc/results/${g}-${p}.json`, 'utf8')), notes: []}) as SolveResult;
  for (let n = part; n < 204; n += parts) {
    const next = chance(n + 1000 * Number(process.env['SEED'] ?? 0));
    const group = at(groupNames, n % 17), garment = at(garments, Math.floor(n / 17));
    const results = [read(garment, group)];
    if (next() < 0.15) results.push(read('apron', group));
    const {settings, rules} = randomLay(at(results, 0).print, next);
    const t = Date.now();
    let line = '';
    try {
      const plan = await marker(results.map((result) => ({result, options: {grain: {default: 'on'}, plain: ['waistband']}})), settings);
      const wrong = planComplaints(plan, results, {...rules, plain: ['waistband']});
      line = wrong.length ? 'WRONG ' + wrong.slice(0, 4).join(' | ') : `ok ${plan.lengthCm.toFixed(1)} ${plan.unplaced.length}`;
    } catch (e) { line = (e instanceof SolverError ? 'refused ' : 'THROWN ') + String((e as Error).message); }
    appendFileSync(`/tmp/rc/sweep-${process.env['SEED'] ?? 0}.txt`, `${n} ${garment} ${group} ${line} ${Date.now() - t} ms ${JSON.stringify(settings)}\n`);
  }
});
