// `npm run dev`: serves the page from its sources. Changes of TypeScript show at once, and a type
// check runs in parallel. A change of C++ rebuilds the module and reloads the page. Errors don't
// end it; it runs until it is stopped.
import {spawn} from 'node:child_process';
import {relative} from 'node:path';

import {again} from './again.mjs';
import {build, moduleSources} from './build.mjs';
import {ensurePackages} from './packages.mjs';
import {checkPort} from './port.mjs';
import {main, root, say, SetupError, tool} from './shell.mjs';

/**
 * Compiles the module if it is out of date. @returns whether a module for the current sources
 * exists
 */
async function buildModule() {
  try {
    await build('module');
    return true;
  } catch (error) {
    if (!(error instanceof SetupError)) throw error;
    say(`\n${error.message}\nThe module stays as it was; save a file of wasm/src to try again.`);
    return false;
  }
}

/** The TypeScript compiler, which prints errors after each change. */
function watchTypes() {
  const [node, tsc] = tool('typescript', 'tsc');
  const words = [tsc, '-p', 'tsconfig.json', '--watch', '--preserveWatchOutput', '--pretty'];
  return spawn(node, words, {cwd: root, stdio: ['ignore', 2, 2]});
}

await main(async () => {
  await checkPort();
  await ensurePackages();
  await buildModule();
  const {createServer} = await import('vite'); // installed by now
  const server = await createServer({configFile: `${root}/vite.config.ts`, logLevel: 'info'});
  await server.listen();
  say(`Seamwise is at http://localhost:${server.config.server.port}; Ctrl-C ends it`);

  const changed = again(
    async () => {
      if (!(await buildModule())) return;
      say('The module is built; the page loads it.');
      server.ws.send({type: 'full-reload'});
    },
    (error) => say(error.stack ?? String(error)),
  );
  const watched = moduleSources.map((path) => `${root}${path}`);
  server.watcher.add(watched);
  server.watcher.on('all', (event, path) => {
    if (!watched.some((place) => path === place || path.startsWith(`${place}/`))) return;
    if (event !== 'addDir') say(`${relative(root, path)} has changed`);
    changed();
  });

  const types = watchTypes();
  const end = () => {
    types.kill();
    void server.close().finally(() => process.exit());
  };
  for (const signal of ['SIGINT', 'SIGTERM']) process.once(signal, end);
});
