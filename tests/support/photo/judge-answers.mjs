// Scores the results for the cases of write-cases.mjs:
//   node tests/support/photo/judge-answers.mjs CASES ANSWERS [--json]
// ANSWERS is a folder with NAME.json for each case, in the format of `seamwise photo --json`; the
// file is missing or empty if the image was refused. NAME.print.json, as written by `--out`, is
// needed to score tiles, proportions and angles.
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
