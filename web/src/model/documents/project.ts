/**
 * A design as a file, with the text of its garment, and with the print's image if it is the user's
 * own.
 */
import type {Design} from '../design/design.js';
import {readDesign} from '../design/read-design.js';
import {written} from '../design/written-design.js';
import type {Point} from '../geometry/vectors.js';
import {projectTitle} from './project-name.js';
import {number, pairOf, shape} from '../base/read.js';
import {readVersioned, versionOf, type FileKind} from '../base/versioned-file.js';

/** Position and scale of a view of the sheet. Scale in CSS px per cm. */
export interface ProjectView {
  readonly centre: Point;
  readonly scale: number;
}

export interface Project {
  readonly design: Design;
  readonly view?: ProjectView;
  /** Title given by the owner. */
  readonly title?: string;
}

const version = 1;

const kind: FileKind<Project> = {
  format: 'seamwise-project',
  version,
  read: shape(
    {design: readDesign},
    {
      view: shape({centre: pairOf(number(-1e6, 1e6)), scale: number(1e-3, 1e5)}),
      title: projectTitle,
    },
  ),
  notJson: 'is not JSON; choose a project that was saved by Seamwise.',
  otherKind: 'is no project; choose a file that was saved as a Seamwise project.',
  newer: (written) =>
    `was saved by a newer Seamwise (project format ${written}, this one reads ${version}); load the page again to get the newest one.`,
  damaged: (what) => `is damaged: ${what}; correct it, or open an earlier copy.`,
};

export const writeProject = (design: Design, more: Omit<Project, 'design'> = {}): string =>
  JSON.stringify({format: `${kind.format}/${version}`, design: written(design), ...more});

/** Returns whether a file is a project of any version. */
export const isProject = (file: unknown): boolean => versionOf(file, kind) !== undefined;

/** Reads a project. @throws {FileError} when the text is not a valid project */
export const readProject = (text: string, name: string): Project => readVersioned(text, name, kind);
