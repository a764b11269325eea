// `npm start`: builds the missing parts and serves the page, until it is stopped.
import {build} from './build.mjs';
import {checkPort} from './port.mjs';
import {main, root, say, SetupError} from './shell.mjs';

await main(async () => {
  await checkPort();
  await build('page');
  const vite = await import('vite'); // installed by now
  const configFile = `${root}/vite.config.ts`;
  try {
    const {httpServer} = await vite.preview({configFile, logLevel: 'warn'});
    say(`Seamwise is at http://localhost:${httpServer.address().port}`);
  } catch (error) {
    if (error.code !== 'EADDRINUSE' && !/in use/.test(error.message)) throw error;
    throw new SetupError(`${error.message}; choose another, such as PORT=5174.`);
  }
});
