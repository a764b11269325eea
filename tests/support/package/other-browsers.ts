/**
 * Installed browsers other than Chromium: Firefox and WebKit, each controlled by its own interface.
 */
import {spawn, type ChildProcess} from 'node:child_process';
import {mkdtemp, rm, writeFile} from 'node:fs/promises';
import {createRequire} from 'node:module';
import {createServer, type AddressInfo} from 'node:net';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {setTimeout as sleep} from 'node:timers/promises';

import {Builder, Capabilities} from 'selenium-webdriver';
import type {Index} from 'selenium-webdriver/bidi/index.js';

import {has} from '../../../web/setup/shell.mjs';

/** A page in one of them. */
interface OtherPage {
  /**
   * Evaluates an expression, or the promise it returns, to a text. @throws {Error} when it fails
   */
  readonly evaluate: (expression: string) => Promise<string>;
  readonly close: () => Promise<void>;
}

interface OtherBrowser {
  readonly name: string;
  /** Required programs. */
  readonly needs: readonly string[];
  readonly open: (url: string) => Promise<OtherPage>;
}

/** Starts a program on a virtual display, as not all browsers draw without one. */
function start(command: string, ...words: readonly string[]): ChildProcess {
  const stdio: ['ignore', 'ignore', 'pipe'] = ['ignore', 'ignore', 'pipe'];
  return spawn('xvfb-run', ['--auto-servernum', command, ...words], {stdio, detached: true});
}

/** Ends the program with its display and all processes that it has started. */
async function end(program: ChildProcess): Promise<void> {
  if (program.exitCode !== null || program.pid === undefined) return;
  const ended = new Promise((resolve) => program.once('exit', resolve));
  process.kill(-program.pid);
  await ended;
}

/** Waits for the first group of a pattern in a program's standard error. */
const hear = (program: ChildProcess, pattern: RegExp): Promise<string> =>
  new Promise((resolve, reject) => {
    let said = '';
    program.stderr?.on('data', (text: Buffer) => {
      said += text.toString();
      const found = pattern.exec(said)?.[1];
      if (found !== undefined) resolve(found);
    });
    program.on('exit', () => {
      reject(new Error(`The browser has ended: ${said}`));
    });
  });

// the class is the module itself, contrary to its types
const Connection = createRequire(import.meta.url)('selenium-webdriver/bidi') as typeof Index;

/** The fields of a WebDriver BiDi answer that are read here. */
interface Answer {
  readonly type: 'success' | 'error';
  readonly message?: string;
  readonly result: {
    readonly contexts: readonly {readonly context: string}[];
    readonly type: 'success' | 'exception';
    readonly result: {readonly value: string};
    readonly exceptionDetails: {readonly text: string};
  };
}

/**
 * Firefox supports WebDriver BiDi itself; the older protocol would need geckodriver, which Debian
 * lacks.
 */
const firefox: OtherBrowser = {
  name: 'Firefox',
  needs: ['xvfb-run', 'firefox-esr'],
  open: async (url) => {
    const profile = await mkdtemp(join(tmpdir(), 'seamwise-firefox-'));
    // test machines have no graphics card
    await writeFile(join(profile, 'user.js'), 'user_pref("webgl.force-enabled", true);\n');
    const words = ['--no-remote', '--profile', profile, '--remote-debugging-port', '0'];
    const program = start('firefox-esr', ...words, 'about:blank');
    const address = await hear(program, /WebDriver BiDi listening on (ws:\S+)/);
    const connection = new Connection(`${address}/session`);
    await connection.waitForConnection();
    const ask = async (method: string, params: object): Promise<Answer['result']> => {
      const {type, message, result} = (await connection.send({method, params})) as Answer;
      if (type === 'error') throw new Error(message);
      return result;
    };
    await ask('session.new', {capabilities: {}});
    const {contexts} = await ask('browsingContext.getTree', {});
    const context = contexts[0]?.context;
    await ask('browsingContext.navigate', {context, url, wait: 'complete'});
    return {
      evaluate: async (expression) => {
        const asked = {expression, target: {context}, awaitPromise: true};
        const {type, result, exceptionDetails} = await ask('script.evaluate', asked);
        if (type === 'exception') throw new Error(exceptionDetails.text);
        return result.value;
      },
      close: async () => {
        await connection.close();
        await end(program);
        await rm(profile, {recursive: true, maxRetries: 5});
      },
    };
  },
};

async function freePort(): Promise<number> {
  const server = createServer().listen(0);
  await new Promise((resolve) => server.once('listening', resolve));
  const {port} = server.address() as AddressInfo;
  await new Promise((resolve) => server.close(resolve));
  return port;
}

/** WebKit's driver includes a small browser. */
const webKit: OtherBrowser = {
  name: 'WebKit',
  needs: ['xvfb-run', 'WebKitWebDriver'],
  open: async (url) => {
    const port = await freePort();
    const program = start('WebKitWebDriver', `--port=${port}`);
    const server = `http://127.0.0.1:${port}`;
    for (let tries = 0; tries < 100 && program.exitCode === null; tries++) {
      if (
        await fetch(`${server}/status`)
          .then(({ok}) => ok)
          .catch(() => false)
      )
        break;
      await sleep(100);
    }
    const driver = await new Builder()
      .disableEnvironmentOverrides()
      .usingServer(server)
      .withCapabilities(new Capabilities({browserName: 'MiniBrowser'}))
      .build();
    await driver.get(url);
    return {
      evaluate: (expression) => driver.executeScript<string>(`return ${expression}`),
      close: async () => {
        await driver.quit();
        await end(program);
      },
    };
  },
};

export const otherBrowsers = [firefox, webKit];

/** Required programs that are not installed. */
export const missingOf = ({needs}: OtherBrowser): readonly string[] =>
  needs.filter((program) => !has(program));
