/** The task of a batch thread: solves one job at a time with its own instance of the solver. */
import {problemFor} from '../../model/documents/design-problem.js';
import {drapeFile, drapeText} from '../../model/documents/drape-file.js';
import {SolverError} from '../../model/base/failure.js';
import {glb} from '../../files/glb/glb.js';
import {titleOfFile} from '../../model/garment/piece-names.js';
import {readPrintFile} from '../../model/print/read-print-file.js';
import type {Print} from '../../model/print/repeating-print.js';
import {printOfResult} from '../../model/result/print-of-result.js';
import type {SolveResult} from '../../model/result/result.js';
import {resultText, sha256Of} from '../../model/documents/result-text.js';
import {FileError} from '../../model/base/versioned-file.js';
import {addressOf, readAddress} from '../../node/addresses.js';
import {textOf} from '../../node/files.js';
import {drape, layPlanText, marker, readGarment, solve} from '../../node/index.js';
import {UsageError} from '../base/arguments.js';
import {readCell} from '../base/cell-picture.js';
import {cutFiles, type CutAnswer, type CutWish} from '../base/cut-files.js';
import {laySettings, type LayWish} from '../base/lay-wish.js';
import type {KeyedJob} from './jobs.js';
import {failedFor, failureText, figuresOf, type Outcome} from './outcome.js';
import {Store} from './store.js';

export interface Task {
  readonly job: KeyedJob;
  /** Folder of the results. */
  readonly folder: string;
}

/** The outcome once it is written; or the reason why it could not be written. */
export type Answer = Outcome | {readonly status: 'unwritten'; readonly reason: string};

/** Solves a job that is not finished yet. */
export default async function solveJob({job, folder}: Task): Promise<Answer> {
  const started = performance.now();
  const store = new Store(folder);
  const known = await store.outcome(job.key); // another process may have been faster
  if (known) return known;
  const {outcome, text, beside = {}} = await solved(job);
  if (text === undefined) return outcome;
  try {
    for (const [ending, content] of Object.entries(beside)) {
      await store.writeBeside(job.key, ending, content);
    }
    await store.write(job.key, outcome.status, text);
  } catch (error) {
    return {status: 'unwritten', reason: error instanceof Error ? error.message : String(error)};
  }
  return {...outcome, milliseconds: Math.round(performance.now() - started)};
}

interface Solved {
  readonly outcome: Outcome;
  /** Text of the file that marks the job as finished; undefined if the failure may not recur. */
  readonly text?: string;
  /** Additional files by the ending of their names. */
  readonly beside?: Readonly<Record<string, string | Uint8Array>>;
}

async function solved(job: KeyedJob): Promise<Solved> {
  const {label} = job;
  try {
    const print = await textAt(job.print, label.print, job.printSha256);
    const garment = await textAt(job.garment, label.garment, job.garmentSha256);
    const result = await solve(problemFor(job, garment, print), {
      names: {garment: label.garment, print: label.print},
    });
    const text = resultText(result);
    const beside = {
      ...(job.drape && (await draped(job, print, result, text))),
      ...(job.cut && (await cut(job, job.cut, {garment, print, result}))),
      ...(job.marker && (await laid(job, job.marker, {garment, print, result}))),
    };
    const figures = {metrics: figuresOf(result), sha256: sha256Of(text)};
    return {outcome: {status: 'done', ...figures, milliseconds: null}, text, beside};
  } catch (error) {
    if (error instanceof UsageError) return {outcome: failedFor('not-found', error.message)};
    if (error instanceof FileError) return {outcome: failedFor('not-found', error.message)};
    if (error instanceof SolverError) return refused(error);
    throw error;
  }
}

/**
 * @throws {SolverError} if the garment cannot be draped
 * @throws {FileError} if the print's image cannot be read
 */
async function draped(
  {label, print: address, options}: KeyedJob,
  printText: string,
  result: SolveResult,
  text: string,
): Promise<NonNullable<Solved['beside']>> {
  const print = printOf(result, printText, label.print);
  const picture = await readCell(print, addressOf(address));
  const worn = await drape(text, {}, {names: {result: label.garment}});
  const {plain = []} = options;
  const scene = glb(result, worn, print, {
    ...(picture && {picture}),
    ...{plain, garment: titleOfFile(label.garment), sha256: sha256Of(text)},
  });
  return {'.drape.json': drapeText(drapeFile(result, worn)), '.glb': scene};
}

/** @throws {FileError} if the print's image cannot be read or drawn */
async function cut(
  {label, print: address, options}: KeyedJob,
  wish: CutWish,
  of: {readonly garment: string; readonly print: string; readonly result: SolveResult},
): Promise<NonNullable<Solved['beside']>> {
  const answer: CutAnswer = {
    garment: {
      ...{text: of.garment, name: label.garment},
      ...(label.size !== null && {size: label.size}),
    },
    ...{result: of.result, print: printOf(of.result, of.print, label.print)},
    ...{address: addressOf(address), plain: options.plain ?? []},
  };
  const [pdf = ''] = await cutFiles(answer, ['pdf'], wish);
  return {'.pdf': pdf};
}

/** @throws {SolverError} if the pieces cannot be laid out */
async function laid(
  {label, options}: KeyedJob,
  wish: LayWish,
  of: {readonly garment: string; readonly print: string; readonly result: SolveResult},
): Promise<NonNullable<Solved['beside']>> {
  const garment = await readGarment(of.garment, label.garment);
  const print = printOf(of.result, of.print, label.print);
  const plan = await marker([{result: of.result, garment, options}], {
    ...laySettings(wish),
    print,
  });
  return {'.layplan.json': layPlanText(plan)};
}

/** The print in the size of the result. @throws {FileError} if it cannot be read */
function printOf(result: SolveResult, text: string, called: string): Print {
  const print = readPrintFile(text, called);
  return printOfResult(result.print, print) ?? print;
}

function refused({code, message, piece, seam}: SolverError): Solved {
  // caused by the machine, not the garment
  if (code === 'internal' || code === 'no-wasm') return {outcome: failedFor(code, message)};
  const failure = {code, message, piece, seam};
  const outcome: Outcome = {status: 'failed', failure, milliseconds: null, isFinal: true};
  return {outcome, text: failureText(failure)};
}

/** The most recent files by SHA-256, since consecutive jobs share garments and prints. */
const recent = new Map<string, string>();
const mostRecent = 8;

async function textAt(address: string, called: string, sha256: string): Promise<string> {
  const bytes = recent.get(sha256) ?? (await readAddress(addressOf(address)));
  if (typeof bytes === 'string') return bytes;
  if (sha256Of(bytes) !== sha256) {
    throw new FileError(called, 'was changed after the batch had begun; start the batch again.');
  }
  const text = textOf(bytes);
  for (const oldest of [...recent.keys()].slice(0, Math.max(0, recent.size + 1 - mostRecent))) {
    recent.delete(oldest);
  }
  recent.set(sha256, text);
  return text;
}
