// The command line on a fresh clone: builds what is missing, quietly, and hands over.
import {build} from './build.mjs';
import {main} from './shell.mjs';

await main(async () => {
  await build();
  await import('../../dist/cli/main.js');
});
