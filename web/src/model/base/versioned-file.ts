/** The project's own files, which state the version of their format. */
import {SolverError, type DrawingFault, type FailureCode} from './failure.js';
import {fieldOf, isTooDeep, Malformed, type Read} from './read.js';

/** Code and reason of a file error, and its cause. */
interface FileErrorOptions extends ErrorOptions {
  /** Default `file`. */
  readonly code?: FailureCode;
  /** Reason why a drawing is no pattern. */
  readonly reason?: DrawingFault;
}

/** Why a drawing is no pattern. */
export interface Refusal {
  /** Predicate of an error sentence whose subject is the file name. */
  readonly refusal: string;
  readonly reason: DrawingFault;
}

/**
 * A file that cannot be used. The message is one sentence for people, with the file and the remedy.
 */
export class FileError extends SolverError {
  override readonly name = 'FileError';
  readonly file: string;

  constructor(
    file: string,
    complaint: string,
    {code = 'file', reason, ...options}: FileErrorOptions = {},
  ) {
    super({code, message: `${file} ${complaint}`, ...(reason && {reason})}, options);
    this.file = file;
  }
}

/** One kind of file; each complaint completes a sentence that begins with the file's name. */
export interface FileKind<T> {
  /** The `format` without its version. */
  readonly format: string;
  /** Newest version that can be read. */
  readonly version: number;
  readonly read: Read<T>;
  readonly notJson: string;
  readonly otherKind: string;
  readonly newer: (written: number) => string;
  readonly damaged: (what: string) => string;
}

/** Version of the format that a file states; undefined for a file of another kind. */
export function versionOf(
  file: unknown,
  {format}: Pick<FileKind<unknown>, 'format'>,
): number | undefined {
  const stated = fieldOf(file, 'format');
  if (typeof stated !== 'string' || !stated.startsWith(`${format}/`)) return undefined;
  const digits = stated.slice(format.length + 1);
  return /^\d{1,9}$/.test(digits) ? Number(digits) : undefined;
}

/** Reads a file of this kind. @throws {FileError} when the text is of another kind or not valid */
export function readVersioned<T>(text: string, name: string, kind: FileKind<T>): T {
  const file = parsed(text, name, kind);
  if (isTooDeep(file)) throw new FileError(name, kind.damaged('it is nested too deep'));
  const written = versionOf(file, kind);
  if (written === undefined) throw new FileError(name, kind.otherKind);
  if (written > kind.version) throw new FileError(name, kind.newer(written));
  try {
    return kind.read(file, '');
  } catch (cause) {
    if (!(cause instanceof Malformed)) throw cause;
    throw new FileError(name, kind.damaged(cause.message), {cause});
  }
}

function parsed(text: string, name: string, {notJson}: FileKind<unknown>): unknown {
  try {
    return JSON.parse(text);
  } catch (cause) {
    throw new FileError(name, notJson, {cause});
  }
}
