// `npm start`: builds the missing parts and serves the page, until it is stopped.
import {createServer} from 'node:net';

import {build} from './build.mjs';
import {main, root, say, SetupError} from './shell.mjs';

/** The port of the page. @throws {SetupError} unless PORT is a port that users may open */
function portOf(word = '5173') {
  const port = /^\d{1,5}$/.test(word) ? Number(word) : NaN;
  if (port >= 1 && port <= 65535) return port;
  throw new SetupError(`PORT is '${word}', but must be a number from 1024 to 65535.`);
}

/** Checks a port before anything is built. @throws {SetupError} if it cannot be opened */
const checkPort = (port) =>
  new Promise((resolve, reject) => {
    const server = createServer();
    server.once('error', ({code}) => {
      const reason = {EADDRINUSE: 'is in use', EACCES: 'is reserved for the system'}[code] ?? code;
      reject(
        new SetupError(`Port ${port} ${reason}; choose another, such as PORT=5174 npm start.`),
      );
    });
    server.listen(port, 'localhost', () => server.close(resolve));
  });

await main(async () => {
  await checkPort(portOf(process.env.PORT));
  await build('page');
  const vite = await import('vite'); // installed by now
  const configFile = `${root}/vite.config.ts`;
  try {
    const {httpServer} = await vite.preview({configFile, logLevel: 'warn'});
    say(`Seamwise is at http://localhost:${httpServer.address().port}`);
  } catch (error) {
    if (error.code !== 'EADDRINUSE' && !/in use/.test(error.message)) throw error;
    throw new SetupError(`${error.message}; choose another with PORT=5174 npm start`);
  }
});
