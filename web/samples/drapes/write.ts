/**
 * Writes public/opening.drape: the sample of a first visit, solved and draped. Needs the built
 * package.
 */
import {readFileSync, writeFileSync} from 'node:fs';
import {pathToFileURL} from 'node:url';

import {askingFor, usualFabric} from '../../src/model/design/design.js';
import {problemOf} from '../../src/model/documents/design-problem.js';
import {newDesign, samplePrint, welcome, type Samples} from '../../src/workbench/samples.js';
import {withAll} from '../../src/workbench/symmetry-steps.js';
import {storedDrape} from './encode.js';

/** Greatest size of the file. [bytes] */
const most = 40_000;

const built = pathToFileURL('dist/node/index.js').href;
const {drape, solve, symmetries} = (await import(
  built
)) as typeof import('../../src/node/index.js');

const {style, size} = welcome;
const name = `${style}-${size}.json`;
const text = readFileSync(`public/garments/${name}`, 'utf8');
const {prints} = JSON.parse(readFileSync('public/samples.json', 'utf8')) as Samples;
const print = prints.find((one) => one.name === welcome.print);
if (!print) throw new Error(`There is no print ${welcome.print}.`);
const found = await symmetries(text);
const kept = withAll([], print.group, found.symmetries);
const design = {
  ...newDesign({name, text, sample: {style, size}}, samplePrint(print)),
  symmetry: askingFor(kept),
};
const result = await solve(problemOf(design));
const file = storedDrape({
  sample: welcome,
  symmetries: kept,
  alignments: result.pieces.map(({alignment}) => alignment),
  drape: await drape(result, {fabric: usualFabric}),
});
if (file.length > most) throw new Error(`public/opening.drape has ${file.length} bytes.`);
writeFileSync('public/opening.drape', file);
