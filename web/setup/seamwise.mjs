// The command line on a fresh clone: builds the missing parts quietly, and runs it.
import {build} from './build.mjs';
import {main} from './shell.mjs';

await main(async () => {
  await build('scripts');
  // npm changes to the project's folder, but paths are relative to the user's current directory
  process.chdir(process.env.INIT_CWD ?? '.');
  await import('../../dist/cli/main.js');
});
