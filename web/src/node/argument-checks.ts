/** Checks the settings and hooks of the functions of `seamwise/node`: types, ranges and names. */
import {
  bytes,
  callback,
  checkedLater,
  date,
  either,
  fields,
  having,
  optional,
  readable,
  signal,
  type Checks,
} from '../model/base/arguments.js';
import {
  fail,
  flag,
  listOf,
  Malformed,
  number,
  oneOf,
  pairOf,
  recordOf,
  text,
  wholeNumber,
  type Read,
} from '../model/base/read.js';
import {greatestAllowance} from '../cutting/allowance-rule.js';
import {printInks} from '../cutting/print-ink.js';
import type {MarkerSettings} from '../marker/settings.js';
import type {Problem, ProofHooks, SolveHooks} from '../model/design/solve-problem.js';
import {checkedResult} from '../model/documents/checked-result.js';
import {unitsInMetre} from '../model/garment/garment-document.js';
import type {PhotoHooks} from '../model/print/photo-reading.js';
import type {DrapeHooks} from '../model/result/draped-garment.js';
import {noPaper, paperOf} from '../paper/papers.js';
import type {SuggestionSettings} from '../pairing/report.js';
import {languages} from '../texts/preferences.js';
import type {
  NamedDrapeHooks,
  NamedPrepareHooks,
  NamedProofHooks,
  NamedSolveHooks,
  ProblemNames,
} from '../solver/requests/requests.js';
import {photoFacts} from '../solver/requests/later-checks.js';
import type {CommonSizeHooks} from './common-size.js';
import type {CutSettings} from './cut.js';
import {
  cutSheet,
  filedDesign,
  garmentDocument,
  laidGarment,
  layPlan,
  numberOrNull,
  print,
} from './document-checks.js';
import type {ImportOptions} from './import.js';
import type {ConvertOptions, GarmentDxfOptions, RemedyHooks} from './options.js';
import type {LayPlanSettings} from './lay-plan.js';
import type {MarkerPlanHooks, NodeMarkerSettings} from './marker.js';
import type {Order, OrderHooks} from './order.js';
import type {OrderRecordSettings} from './order-record.js';
import type {PrintFromPixelsSettings} from './photo.js';
import {dxfFormat, title} from './setting-checks.js';

const word = text();
const names = recordOf(word);

const jsonText: Read<unknown> = (value, at) => {
  try {
    return value === '' ? value : (JSON.parse(word(value, at)) as unknown);
  } catch {
    return fail(at, 'JSON text');
  }
};
const object: Read<object> = (value, at) => readable(having({})(value, at));
const document = either('an object or its JSON text', jsonText, object);

/** A problem that has a result already; the solver checks the rest. */
export const solvedProblem = having<Problem>({
  ...{garment: document, print: document, options: optional(document)},
});

export const solvedProblems = listOf(solvedProblem);

const allowance = number(0, greatestAllowance);

const problemNames = fields<Partial<ProblemNames>>({
  ...{garment: word, print: word, symmetry: word, options: word},
});
const prepare: Checks<NamedPrepareHooks> = {signal, names: problemNames};
const proof: Checks<ProofHooks> = {signal, onProof: callback};
const solve: Checks<SolveHooks> = {
  ...{signal, onPattern: callback, onProgress: callback, onPartial: callback},
  ...{onCompared: callback, onRefused: callback},
};
const draping: Checks<DrapeHooks> = {
  ...{signal, onMesh: callback, onForm: callback, onPositions: callback, onProgress: callback},
};

export const solveHooks = fields<NamedSolveHooks>({...solve, names: problemNames});
export const commonSizeHooks = fields<CommonSizeHooks>({
  ...{signal, names: listOf(problemNames), onSolve: callback},
  ...{onCompared: callback, onRefused: callback},
});
export const prepareHooks = fields<NamedPrepareHooks>(prepare);
export const remedyHooks = fields<RemedyHooks>({...prepare, onRemedy: callback});
export const proofHooks = fields<NamedProofHooks>({...proof, names: problemNames});
export const drapeHooks = fields<NamedDrapeHooks>({
  ...{...draping, names: fields<{result?: string; body?: string}>({result: word, body: word})},
});
export const photoHooks = fields<PhotoHooks>({signal, onProgress: callback});
export const markerHooks = fields<MarkerPlanHooks>({
  ...{signal, onProgress: callback, onLayout: callback},
});

const paper: Read<string> = (value, at) => {
  const name = word(value, at);
  if (paperOf(name)) return name;
  throw new Malformed(noPaper(name.slice(0, 40)).replace(/\.$/, ''));
};

const grainRules = recordOf(either('a grain rule', word, having({})));

export const cutSettings = fields<CutSettings>(
  {
    ...{print, garment: garmentDocument, garmentFile: word, names, grain: grainRules},
    ...{allowanceCm: allowance, hemCm: allowance, colourway: word, plain: listOf(word)},
    ...{
      paper,
      ink: oneOf(printInks),
      guide: flag,
      date,
      mark: title,
      pixels: callback,
      blankPages: flag,
      language: oneOf(languages),
      under: cutSheet,
      fonts: listOf(bytes),
    },
  },
  'print',
);

/** A number whose range is checked with better words later. */
const anyNumber: Read<number> = (value, at) =>
  typeof value === 'number' ? value : fail(at, 'a number');

/** `checkedSettings` checks the ranges. */
const marking: Checks<MarkerSettings> = {
  ...{widthCm: anyNumber, selvedgeCm: anyNumber, gapCm: anyNumber},
  ...{copies: anyNumber, phaseCm: anyNumber, startCm: anyNumber},
  ...{allowanceCm: anyNumber, hemCm: anyNumber, plies: anyNumber},
  ...{repeatTolerance: anyNumber, effort: anyNumber, seed: anyNumber},
  ...{nap: checkedLater, shift: checkedLater, fold: flag, ignoresPrint: flag},
  ...{flaws: listOf(listOf(pairOf(anyNumber))), widthsCm: listOf(anyNumber)},
};

export const markerSettings = fields<MarkerSettings>(marking, 'widthCm');

export const nodeMarkerSettings = fields<NodeMarkerSettings>(
  {...marking, print: object},
  'widthCm',
);

export const laidGarments = listOf(laidGarment);

export const layPlanSettings = fields<LayPlanSettings>(
  {
    ...{print, units: oneOf(['cm', 'inch']), title: word, date, pixels: callback},
    ...{names: callback, results: laidGarments},
  },
  'print',
);

const folder = either('a URL or a path', word, (value, at) =>
  value instanceof URL ? value : fail(at, 'a URL'),
);

export const orderHooks = fields<OrderHooks>({
  ...{...solve, read: callback, base: folder, name: title, cloth: markerSettings},
  ...{within: listOf(folder), timeoutMs: number(1, 1e9)},
});

/** A design that was solved; its options were read with it. */
const soldDesign: Read<unknown> = (value, at) => {
  filedDesign(value, at);
  return having({solver: word, result: word, options: having({})})(value, at);
};

export const solvedOrder = having<Order>({
  ...{design: soldDesign, garment: word, print, result: checkedResult, reproduced: flag},
  ...{differenceCm: numberOrNull, plan: optional(layPlan)},
});

export const orderRecordSettings = fields<OrderRecordSettings>({tile: word});

export const importOptions = fields<ImportOptions>({
  ...{name: word, size: word, pixelsPerInch: number(1, 100_000), pages: listOf(wholeNumber)},
  ...{grid: pairOf(number(1, 1000)), trimCm: number(0, 100), overlapCm: number(0, 100)},
  ...{allowanceCm: allowance, seams: oneOf(['suggest', 'file', 'none'])},
  ...{units: oneOf(Object.keys(unitsInMetre)), scale: number(1e-3, 1e3)},
  measured: fields<NonNullable<ImportOptions['measured']>>({
    ...{piece: word, longerCm: number(0.1, 10_000)},
  }),
});

export const suggestionSettings = fields<SuggestionSettings>({
  ...{strip: flag, confirm: wholeNumber, seed: number(0, 0xffffffff)},
});

export const convertOptions = either(
  "an object with 'name', 'plain' and 'dividePleats', or the name",
  word,
  fields<ConvertOptions>({name: word, plain: flag, dividePleats: flag}),
);

export const garmentDxfOptions = fields<GarmentDxfOptions>({
  ...{...dxfFormat, sewAsBoundary: flag, name: word, allowanceCm: allowance},
});

export const photoSettings = fields<PrintFromPixelsSettings>({...photoFacts, symmetrise: flag});
