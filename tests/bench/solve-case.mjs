// One worker process of `npm run compare`: solves what it is sent, and answers with the figures.
import {readFileSync} from 'node:fs';
import {fileURLToPath} from 'node:url';

import {solve} from '../../dist/node/index.js';
import {randomSeamFit} from './seam-fit.mjs';

const text = (file) => readFileSync(file, 'utf8');
const sample = (name) => fileURLToPath(new URL(`../../public/${name}.json`, import.meta.url));

async function figures({garment, print, symmetry, seed}) {
  const problem = {garment: text(garment), print: text(print), symmetry, seed};
  const best = await solve({...problem, method: 'best'});
  const paper = await solve({...problem, method: 'paper'});
  return {
    best: chosen(best),
    paper: chosen(paper),
    fitRandom: best.metrics.fitRandom,
    fitSeamRandom: randomSeamFit(best),
  };
}

const chosen = ({metrics: {fit, fitSeam, milliseconds}}) => ({fit, fitSeam, milliseconds});

process.on('message', async (task) => {
  try {
    process.send(await figures(task));
  } catch (error) {
    process.send({failure: error instanceof Error ? error.message : String(error)});
  }
});

// The engine compiles hot code once more, and better, while it runs: not a matter of the methods.
await figures({
  garment: sample('garments/gathered-skirt-m'),
  print: sample('prints/pmm'),
  symmetry: 'auto',
  seed: 1,
});
process.send('ready');
