// The port of `npm start` and `npm run dev`, checked before anything is built.
import {createServer} from 'node:net';

import {SetupError} from './shell.mjs';

/** @throws {SetupError} unless the word is a port that users may open */
function portIn(word) {
  const port = /^\d{1,5}$/.test(word) ? Number(word) : NaN;
  if (port >= 1 && port <= 65535) return port;
  throw new SetupError(`PORT is '${word}', but must be a number from 1024 to 65535.`);
}

/** @throws {SetupError} if the port of the variable PORT, by default 5173, cannot be opened */
export async function checkPort() {
  const port = portIn(process.env.PORT ?? '5173');
  await new Promise((resolve, reject) => {
    const server = createServer();
    server.once('error', ({code}) => {
      const reason = {EADDRINUSE: 'is in use', EACCES: 'is reserved for the system'}[code] ?? code;
      reject(new SetupError(`Port ${port} ${reason}; choose another, such as PORT=5174.`));
    });
    server.listen(port, 'localhost', () => server.close(resolve));
  });
}
