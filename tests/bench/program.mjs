// Runs the benchmark's program, natively or in WebAssembly: tasks in, figures out.
import {spawn} from 'node:child_process';
import {mkdtempSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

import {root, SetupError} from '../../web/setup/shell.mjs';

export class Programs {
  #commands;
  #warmUps;

  /**
   * @param commands  command line that starts the program, per platform
   * @param warmUps  problems that workers solve while files are still loading
   */
  constructor(commands, warmUps) {
    this.#commands = commands;
    this.#warmUps = warmUps;
  }

  /**
   * Runs tasks in one fresh process, one after the other, once it is warm.
   * @returns their answers, in order
   * @throws {SetupError} when a task fails or the process breaks
   */
  async ask(platform, tasks) {
    const folder = mkdtempSync(join(tmpdir(), 'seamwise-bench-'));
    try {
      const at = (name) => join(folder, name);
      const file = at('tasks.jsonl');
      const warmUps = this.#warmUps.map(({garment, print}, k) => {
        const files = {garment: at(`garment-${k}.json`), print: at(`print-${k}.json`)};
        writeFileSync(files.garment, garment);
        writeFileSync(files.print, JSON.stringify(print));
        return {task: 'solve', ...files};
      });
      const lines = [...warmUps, ...tasks].map((task) => `${JSON.stringify(task)}\n`);
      writeFileSync(file, lines.join(''));
      const [command, ...words] = this.#commands[platform];
      const answers = (await output(command, [...words, file])).trim().split('\n');
      if (answers.length !== lines.length)
        throw new SetupError(`the ${platform} program broke off`);
      const read = answers.map((line) => JSON.parse(line));
      const broken = read.find(({failure}) => failure !== undefined);
      if (broken) throw new SetupError(`${platform}: ${broken.failure}`);
      return read.slice(warmUps.length);
    } finally {
      rmSync(folder, {recursive: true});
    }
  }

  /** Runs one task on every platform, one after the other. */
  async onBoth(task) {
    const [native] = await this.ask('native', [task]);
    const [wasm] = await this.ask('wasm', [task]);
    return {native, wasm};
  }
}

function output(command, words) {
  return new Promise((resolve, reject) => {
    const said = [];
    const child = spawn(command, words, {cwd: root, stdio: ['ignore', 'pipe', 'inherit']});
    child.stdout.on('data', (chunk) => said.push(chunk));
    child.on('error', (error) => reject(new SetupError(`${command}: ${error.message}`)));
    child.on('close', (code) => {
      if (code === 0) resolve(Buffer.concat(said).toString());
      else reject(new SetupError(`${command} ended with code ${code}`));
    });
  });
}
