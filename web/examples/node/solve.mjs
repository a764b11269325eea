// Solves a garment in a print, and writes the result: node solve.mjs GARMENT.json PRINT.json
// RESULT.json
import {readFile, writeFile} from 'node:fs/promises';

import {resultText, solve} from 'seamwise/node';

const [garmentFile, printFile, resultFile] = process.argv.slice(2);
const [garment, print] = await Promise.all(
  [garmentFile, printFile].map((file) => readFile(file, 'utf8')),
);
const result = await solve({garment, print});
await writeFile(resultFile, resultText(result));
const {fit, fitRandom} = result.metrics;
console.log(`mismatch ${fit.toFixed(1)} cm², by chance ${fitRandom.toFixed(1)} cm²`);
