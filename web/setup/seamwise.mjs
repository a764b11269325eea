// The command line on a fresh clone: builds what is missing, quietly, and hands over.
import {build} from './build.mjs';
import {main} from './shell.mjs';

await main(async () => {
  await build('scripts');
  // npm changes to the project's folder; file names count from where the user stands
  process.chdir(process.env.INIT_CWD ?? '.');
  await import('../../dist/cli/main.js');
});
