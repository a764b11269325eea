// Judges what was read from the cases that write-cases.mjs wrote:
//   node tests/support/photo/judge-answers.mjs CASES ANSWERS [--json]
// ANSWERS holds NAME.json for each case, as `seamwise photo --json` prints it; none or an empty one where it
// refused the picture; and NAME.print.json, as `--out` writes it, if tiles, proportions and angles are to be judged.
import {fileURLToPath} from 'node:url';

import {runnerImport} from 'vite';

const at = (path) => fileURLToPath(new URL(path, import.meta.url));
const [cases = '', answers = '', ...flags] = process.argv.slice(2);

const {module} = await runnerImport(at('judge-answers.ts'), {
  configFile: false,
  resolve: {alias: {'@/': at('../../../web/src/')}},
});
const judged = await module.judgeAnswers(cases, answers);
process.stdout.write(
  `${flags.includes('--json') ? JSON.stringify(judged, null, 1) : module.summaryOf(judged)}\n`,
);
