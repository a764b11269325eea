/** A design as a file: with the text of its garment, and its print's picture where that is the user's own. */
import type {Design} from './design.js';
import {readDesign} from './design-reader.js';
import type {Point} from './geometry.js';
import {fieldOf, Malformed, number, pairOf, shape, type Read} from './read.js';

/** Where a view of the sheet stood. Scale in CSS px per cm. */
export interface ProjectView {
  readonly centre: Point;
  readonly scale: number;
}

export interface Project {
  readonly design: Design;
  readonly view?: ProjectView;
}

/** A file that cannot be used. The message is one sentence for people: it names the file and the remedy. */
export class FileError extends Error {
  override readonly name = 'FileError';
  readonly file: string;

  constructor(file: string, complaint: string, options?: ErrorOptions) {
    super(`${file} ${complaint}`, options);
    this.file = file;
  }
}

const version = 1;

export const writeProject = (design: Design, {view}: Pick<Project, 'view'> = {}): string =>
  JSON.stringify({format: `seamwise-project/${version}`, design, ...(view && {view})});

const reading: Read<Project> = shape(
  {design: readDesign},
  {view: shape({centre: pairOf(number(-1e6, 1e6)), scale: number(1e-3, 1e5)})},
);

function parsed(text: string, name: string): unknown {
  try {
    return JSON.parse(text);
  } catch (cause) {
    throw new FileError(name, 'is not JSON; choose a project that was saved by Seamwise.', {cause});
  }
}

function versionOf(file: unknown): number | undefined {
  const format = fieldOf(file, 'format');
  const [, digits] = /^seamwise-project\/(\d+)$/.exec(String(format)) ?? [];
  return digits === undefined ? undefined : Number(digits);
}

/** Whether a file says that it is a project, of whatever version. */
export const isProject = (file: unknown): boolean => versionOf(file) !== undefined;

/** @throws {FileError} when the text is no project, or not a sound one */
export function readProject(text: string, name: string): Project {
  const file = parsed(text, name);
  const written = versionOf(file);
  if (written === undefined) {
    throw new FileError(name, 'is no project; choose a file that was saved as a Seamwise project.');
  }
  if (written > version) {
    throw new FileError(
      name,
      `was saved by a newer Seamwise (project format ${written}, this one reads ${version}); load the page again to get the newest one.`,
    );
  }
  try {
    return reading(file, '');
  } catch (error) {
    if (!(error instanceof Malformed)) throw error;
    throw new FileError(
      name,
      `is damaged: ${error.message}; correct it, or open an earlier copy.`,
      {
        cause: error,
      },
    );
  }
}
