/** Finds the change that a history step made, so that undo can name it. */
import {
  askedSymmetries,
  fabricOf,
  type Design,
  type DesignGarment,
} from '../../model/design/design.js';
import type {SolveOptions} from '../../model/design/options.js';
import {fieldOf} from '../../model/base/read.js';
import type {Symmetry} from '../../model/garment/symmetries.js';
import {solveSettingsOf, type SolveSettings} from '../presets.js';
import {withQuarterTurn} from '../lists/changed-options.js';
import {textsOf, type Texts} from '../../texts/texts.js';
import {printName} from '../../texts/sample-names.js';
import {seamRows} from '../lists/rows.js';
import type {Step} from '../state.js';
import type {Workbench} from '../workbench.js';

/** A kind of change, and its pieces or seams if it does not concern the whole design. */
export interface Change {
  readonly kind: keyof Texts['steps'];
  /** Names in the garment file. */
  readonly pieces?: readonly string[];
  /** Indices of seams. */
  readonly seams?: readonly number[];
}

const differ = (a: unknown, b: unknown): boolean => JSON.stringify(a) !== JSON.stringify(b);

type Table = Readonly<Record<string, unknown>>;

/** The keys under which two tables differ. */
function changedIn(a: Table = {}, b: Table = {}): readonly string[] {
  return Object.keys({...a, ...b}).filter((key) => differ(a[key], b[key]));
}

/** Elements of only one of two lists. */
const apart = <T>(a: readonly T[] = [], b: readonly T[] = []): readonly T[] => [
  ...a.filter((one) => !b.includes(one)),
  ...b.filter((one) => !a.includes(one)),
];

/**
 * Returns the first difference in a fixed order, since another garment also has other symmetries.
 */
export function changeBetween(from: Design, to: Design): Change {
  const [kind] = [garmentChange(from, to), printChange(from, to)].filter((one) => one);
  if (kind) return {kind};
  if (differ(from.symmetry, to.symmetry)) return symmetryChange(from, to);
  if (from.seed !== to.seed) return {kind: 'better'};
  const names = changedIn(from.names, to.names);
  if (names.length > 0) return {kind: 'name', pieces: names};
  if (fabricOf(from) !== fabricOf(to)) return {kind: 'fabric'};
  if (from.added !== to.added || from.copies !== to.copies) return {kind: 'garments'};
  return (
    pieceGrain(from.options, to.options) ??
    fittingChange(from, to) ??
    optionChange(from.options, to.options) ?? {kind: 'cutting'}
  );
}

function garmentChange({garment: a}: Design, {garment: b}: Design): Change['kind'] | undefined {
  if (a.name === b.name && a.text === b.text) return undefined;
  if (a.sample && a.sample.style === b.sample?.style) return 'size';
  if (a.name !== b.name) return 'garment';
  const [before, after] = [a, b].map(patternText);
  if (before === after) return 'unit';
  return foldsIn(before) === foldsIn(after) ? 'seams' : 'folds';
}

/** The folds in the text of a pattern. */
const foldsIn = (text = ''): string => String(text.match(/"folds":\[.*?\}\]/g));

const known = new WeakMap<DesignGarment, string>();

/** All of a garment but its unit of length: outlines and seams. */
function patternText(garment: DesignGarment): string {
  const text = known.get(garment) ?? JSON.stringify(fieldOf(JSON.parse(garment.text), 'pattern'));
  known.set(garment, text);
  return text;
}

function printChange({print: p}: Design, {print: q}: Design): Change['kind'] | undefined {
  if (p.title !== q.title || p.group !== q.group || p.sample?.name !== q.sample?.name)
    return 'print';
  if (p.image !== q.image) return p.sample ? 'colours' : 'print';
  if (differ(p.size, q.size)) return 'printSize';
  if (p.turnDeg !== q.turnDeg) return 'turn';
  return differ(p, q) ? 'print' : undefined;
}

const piecesOf = (one: Symmetry): readonly string[] =>
  one.kind === 'piece' ? [one.piece] : one.pieces;

function symmetryChange(from: Design, to: Design): Change {
  const [before, after] = [from, to].map((design) =>
    askedSymmetries(design).map((one) => JSON.stringify(one)),
  );
  const changed = apart(before, after).map((one) => JSON.parse(one) as Symmetry);
  return {kind: 'symmetry', pieces: [...new Set(changed.flatMap(piecesOf))]};
}

/** Change to the grain of single pieces; a quarter turn is `turned`. */
function pieceGrain(from: SolveOptions, to: SolveOptions): Change | undefined {
  const pieces = changedIn(from.grain?.pieces, to.grain?.pieces);
  if (pieces.length === 0) return undefined;
  const turned = pieces.reduce(withQuarterTurn, from);
  const isTurn = !differ(turned.grain?.pieces, to.grain?.pieces);
  return {kind: isTurn ? 'turned' : 'grain', pieces};
}

const settingNames: Readonly<Record<keyof SolveSettings, Change['kind']>> = {
  ...{maxChangeCm: 'change', grain: 'grain', continuousOnly: 'cutting', method: 'method'},
};

/** Several settings changed at once are `cutting`. */
function fittingChange(from: Design, to: Design): Change | undefined {
  const changed = changedIn({...solveSettingsOf(from)}, {...solveSettingsOf(to)});
  const [only] = changed as (keyof SolveSettings)[];
  if (only === undefined) return undefined;
  return {kind: changed.length === 1 ? settingNames[only] : 'cutting'};
}

/** Pins follow other decisions, so they are compared last. */
function optionChange(from: SolveOptions, to: SolveOptions): Change | undefined {
  const locked = changedIn(from.locked, to.locked);
  if (locked.length > 0) return {kind: 'keep', pieces: locked};
  if (from.openEdges !== to.openEdges) return {kind: 'openEdges'};
  const seams = new Set([
    ...changedIn(from.weights, to.weights).map(Number),
    ...apart(from.unmatched, to.unmatched),
  ]);
  if (seams.size > 0) return {kind: 'matching', seams: [...seams]};
  const plain = apart(from.plain, to.plain);
  if (plain.length > 0) return {kind: 'printed', pieces: plain};
  const pinned = changedIn(from.pins, to.pins);
  return pinned.length > 0 ? {kind: 'place', pieces: pinned} : undefined;
}

// Names of history steps: "turn Waistband", "matching of seams, Side seam".

/** A step of more pieces or seams lists none. */
const mostNamed = 2;

/** Returns undefined if there is no step. */
function stepWords(
  workbench: Workbench,
  texts: Texts,
  from: Step | undefined,
  to: Step | undefined,
): string | undefined {
  if (!from || !to) return undefined;
  const change = changeBetween(from.design, to.design);
  const named = namesIn(workbench, texts, change, to.design);
  const whose = named.length > mostNamed ? '' : named.join(', ');
  const {turned, ...steps} = texts.steps;
  if (change.kind === 'turned') return turned(whose || texts.lists.pieces);
  return whose ? `${steps[change.kind]}, ${whose}` : steps[change.kind];
}

/** Returns the name of the step that undo reverts. */
export function undoWords(workbench: Workbench, texts: Texts): string | undefined {
  const {past = [], present} = workbench.history.steps ?? {};
  return stepWords(workbench, texts, past.at(-1), present);
}

/** Returns the name of the step that redo repeats. */
export function redoWords(workbench: Workbench, texts: Texts): string | undefined {
  const {present, future = []} = workbench.history.steps ?? {};
  return stepWords(workbench, texts, present, future[0]);
}

/** Undoes the last step and shows its name in a notice, for callers that display no name. */
export function undoAndSay(workbench: Workbench): void {
  const texts = textsOf(
    workbench.preferences.chosen.language,
    workbench.preferences.chosen.messages,
  );
  const undone = undoWords(workbench, texts);
  workbench.history.undo();
  if (undone !== undefined) workbench.notices.say({tone: 'info', text: texts.app.undone(undone)});
}

function namesIn(
  workbench: Workbench,
  texts: Texts,
  {kind, pieces = [], seams = []}: Change,
  {print, garment, names}: Design,
): readonly string[] {
  const {size} = garment.sample ?? {};
  if (kind === 'size' && size !== undefined) return [size.toUpperCase()];
  if (kind === 'print') return [printName(print, texts)];
  const labels = new Map(workbench.sheet.scenes?.now.pieces.map(({name, label}) => [name, label]));
  const rows = seams.length > 0 ? seamRows(workbench, texts) : [];
  return [
    ...pieces.map((name) => names?.[name] ?? labels.get(name) ?? name),
    ...seams.flatMap((seam) => rows[seam]?.name ?? []),
  ];
}
