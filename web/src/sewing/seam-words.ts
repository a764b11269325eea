/** Texts of the sewing tool on choices, questions and refusals. */
import {has, type Run} from '../clicks/run.js';
import {
  questionOf,
  type SeamState,
  type Sewing,
  type SuggestedSeam,
  type Suggestion,
} from '../clicks/seam-tool.js';
import {edgeOf, isOpen, seamAt, sideLength, twinOf} from '../model/garment/edits.js';
import type {Format} from '../texts/format.js';
import type {SewTexts} from '../texts/sew-texts.js';
import type {Texts} from '../texts/texts.js';
import type {EdgeNames} from './edited-pattern.js';
import {allEdges} from './sewing.js';
import {easeOf} from './seam-edits.js';

/** Smaller ease does not matter in sewing. [cm] */
const leastEase = 0.05;
/** Ease from which it is given as a length. [cm] */
const mostFine = 2;

export interface Speech {
  readonly names: EdgeNames;
  readonly sew: SewTexts;
  readonly format: Format;
  /** Names of the places of seams. */
  readonly places: Texts['places'];
}

const easeWords = ({garment}: Sewing, a: Run, b: Run, {sew, format}: Speech): string => {
  const {cm} = easeOf(garment, a, b);
  return cm < leastEase
    ? sew.noEase
    : sew.ease(cm < mostFine ? format.fine(cm) : format.length(cm));
};

/** Capitalizes the start of a sentence. */
const capital = (text: string): string => text.slice(0, 1).toLocaleUpperCase() + text.slice(1);

const named = ({garment}: Sewing, run: Run, {names, sew, format}: Speech): string =>
  capital(sew.chosen(names.ofRun(run), format.length(sideLength(garment, run))));

/** "12 of 31 edges sewn, 6 open" */
export function countWords({garment}: Sewing, sew: SewTexts): string {
  const all = allEdges(garment);
  const open = all.filter((edge) => isOpen(edgeOf(garment, edge)));
  return sew.count(2 * garment.seams.length, all.length, open.length);
}

/**
 * Returns the text of an edge in the list for screen readers: its name, its length and its state.
 */
export function edgeWords(sewing: Sewing, run: Run, speech: Speech): string {
  const {garment} = sewing;
  const {sew, names} = speech;
  const [first] = run;
  const seam = first && garment.seams[seamAt(garment, first) ?? -1];
  const state = seam
    ? sew.sewnTo(names.of(twinOf(seam, first)), easeWords(sewing, [seam.a], [seam.b], speech))
    : first && isOpen(edgeOf(garment, first))
      ? sew.staysOpen
      : '';
  return [named(sewing, run, speech), state].filter((text) => text !== '').join(' ');
}

function bestWords(
  run: Run,
  {a, b}: Suggestion,
  {garment}: Sewing,
  {names, sew, format}: Speech,
): string {
  const [to, length] = [names.ofRun(b), format.length(sideLength(garment, b))];
  const more = a.filter((edge) => !has(run, edge));
  return more.length === 0 ? sew.best(to, length) : sew.bestWith(names.ofRun(more), to, length);
}

function runWords(state: SeamState, sewing: Sewing, speech: Speech): string {
  const {run, other, isHeld, isTurned} = state;
  const {garment} = sewing;
  const {sew, names} = speech;
  const [first] = run;
  const said = edgeWords(sewing, run, speech);
  if (!first || seamAt(garment, first) !== undefined || isOpen(edgeOf(garment, first))) return said;
  const best = sewing.best(run);
  const next =
    other.length > 0
      ? sew.preview(names.ofRun(other), easeWords(sewing, run, other, speech))
      : isHeld
        ? sew.held
        : best
          ? bestWords(run, best, sewing, speech)
          : sew.noMatch;
  return [said, next, isTurned ? sew.turned : ''].filter((text) => text !== '').join(' ');
}

function questionWords(state: SeamState, sewing: Sewing, speech: Speech): string {
  const {sew, names, format} = speech;
  const question = questionOf(state, sewing);
  if (question?.kind === 'gathered') {
    const seam = sewing.garment.seams[question.seams[0] ?? -1];
    const {cm, share} = seam ? easeOf(sewing.garment, [seam.a], [seam.b]) : {cm: 0, share: 0};
    const asked = sew.gathered(format.percent(share), format.fine(cm));
    const {instead} = question;
    return instead ? `${asked} ${sew.orJoined(names.ofRun(instead.a))}` : asked;
  }
  return question ? seamQuestion(question, sewing, speech) : sew.nothingSure;
}

/** "Side seams: sew Skirt front to Skirt back? 67 cm, ease 2 mm." */
function seamQuestion(question: SuggestedSeam, sewing: Sewing, speech: Speech): string {
  const {sew, names, places, format} = speech;
  const {a, b, place = 'other', isPaired = false} = question;
  const [from, to] = [names.piecesOf(a), names.piecesOf(b)];
  const lengths = `${format.length(sideLength(sewing.garment, a))}, ${easeWords(sewing, a, b, speech)}.`;
  if (place === 'other') {
    const asked =
      a.length + b.length > 2 || from === to
        ? sew.asksPieces(from, to)
        : sew.isSewn(names.ofRun(a), names.ofRun(b));
    return `${asked} ${lengths}`;
  }
  const where = capital(isPaired ? places[place].many : places[place].one);
  const asked = from === to ? sew.asksItself(where, from) : sew.asks(where, from, to);
  return `${asked} ${lengths}`;
}

export function seamWords(state: SeamState, sewing: Sewing, speech: Speech): string {
  const {sew} = speech;
  if (state.refused) return sew.refusals[state.refused];
  if (state.gathered.length > 0) return questionWords(state, sewing, speech);
  if (state.run.length > 0) return runWords(state, sewing, speech);
  if (state.suggests) return questionWords(state, sewing, speech);
  const {garment} = sewing;
  const isDone = allEdges(garment).every(
    (edge) => seamAt(garment, edge) !== undefined || isOpen(edgeOf(garment, edge)),
  );
  return isDone ? sew.finished : sew.begin;
}
