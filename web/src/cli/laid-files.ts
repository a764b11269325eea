/** Reads the files of a layout: results, and projects with one or several garments. */
import {isProject, readProject} from '../model/documents/project.js';
import {problemOf} from '../model/documents/design-problem.js';
import {garmentsOnFabric, noPicture, printOf, type Design} from '../model/design/design.js';
import {chosenNames} from '../model/garment/panel-marks.js';
import type {Print} from '../model/print/repeating-print.js';
import {readPrintFile} from '../model/print/read-print-file.js';
import {readBytes, resultLimit, textOf} from '../node/files.js';
import {readGarment, solve, type MarkerGarment} from '../node/index.js';
import {readPrint} from './base/print-files.js';
import {ProgressLine, remark} from './base/terminal.js';
import {asResult, garmentOf, optionsIn, parsed, problemIn, readFabricOf} from './result-file.js';

interface FilesToLay {
  readonly printFile: string;
  readonly garmentFile: string | undefined;
}

/** A garment to be laid, its name in the report, and its print. */
interface LaidFile {
  readonly called: string;
  readonly fabric: Print;
  readonly garment: MarkerGarment;
}

/**
 * The garments of the files, in their order; those of projects are solved.
 * @throws {UsageError}, {FileError} or {SolverError} with the name of an invalid file
 */
export async function readLaidFiles(
  files: readonly string[],
  given: FilesToLay,
): Promise<readonly LaidFile[]> {
  const all: LaidFile[] = [];
  for (const file of files) {
    const text = textOf(await readBytes(file, resultLimit));
    const content = parsed(text, file);
    if (isProject(content))
      all.push(...(await ofProject(readProject(text, file).design, file, given)));
    else all.push(await ofResult(asResult(content, file), file, given));
  }
  if (all.length < 2) return all;
  return all.map((one) => ({...one, garment: {...one.garment, name: one.called}}));
}

async function ofResult(
  result: ReturnType<typeof asResult>,
  file: string,
  {printFile, garmentFile}: FilesToLay,
): Promise<LaidFile> {
  const fabric = await readFabricOf(result, file, {printFile, colourway: undefined});
  const held = await garmentOf(result, garmentFile);
  if (!held) {
    remark(
      `${file} does not hold its design, so all its edges get the same allowance; name the garment with --garment FILE.`,
    );
  }
  const problem = result.otherAlignments && problemIn(result, file, fabric);
  const garment: MarkerGarment = {
    result,
    ...(held && {garment: held.garment}),
    ...{options: optionsIn(result, file), names: chosenNames(result.design)},
    ...(problem && {problem}),
  };
  return {called: file, fabric, garment};
}

/** Solves the garments of a project on its print. The print's file gives the picture. */
async function ofProject(
  design: Design,
  file: string,
  {printFile}: FilesToLay,
): Promise<readonly LaidFile[]> {
  const {image} = readPrintFile(textOf(await readPrint(printFile)), printFile);
  const own = printOf(design.print);
  const embedded = own.image?.startsWith('data:') ? own.image : noPicture;
  const fabric: Print = {...own, image: embedded === noPicture ? (image ?? noPicture) : embedded};
  const progress = new ProgressLine();
  const all: LaidFile[] = [];
  try {
    for (const {copies, ...one} of garmentsOnFabric(design)) {
      const {name, text} = one.garment;
      const called = `${file}, ${name}`;
      progress.write(`Matching ${called}`);
      const result = await solve(problemOf(one), {names: {garment: name, print: file}});
      const garment = await readGarment(text, name);
      const {options, names} = one;
      all.push({
        ...{called, fabric},
        garment: {
          ...{result, copies, garment, options},
          ...(names && {names}),
        },
      });
    }
    return all;
  } finally {
    progress.clear();
  }
}
