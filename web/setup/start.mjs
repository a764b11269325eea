// `npm start`: fits a sample print to a sample garment, and says what came of it and where to look.
import {mkdirSync} from 'node:fs';

import {build} from './build.mjs';
import {main, root, run, SetupError} from './shell.mjs';

const print = 'public/prints/p4m.json';
const result = 'out/tee.json';
const picture = 'out/tee.svg';

await main(async () => {
  await build();
  mkdirSync(new URL('../../out', import.meta.url), {recursive: true});
  await seamwise('align', 'public/garments/tee-m.json', '--print', print, '--out', result);
  await seamwise('draw', result, '--print', print, '--out', picture);
  console.log(`Before and after: ${root}${picture}`);
});

async function seamwise(...words) {
  if (!(await run(process.execPath, ['dist/cli/main.js', ...words], {output: 'inherit'}))) {
    throw new SetupError(`failed: seamwise ${words.join(' ')}`);
  }
}
