/** Reads projects. */
import {readDesign} from '../design/read-design.js';
import {projectTitle} from './project-name.js';
import {number, pairOf, shape} from '../base/read.js';
import {readVersioned, versionOf, type FileKind} from '../base/versioned-file.js';
import {format, version, type Project} from './write-project.js';

const kind: FileKind<Project> = {
  format,
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

/** Returns whether a file is a project of any version. */
export const isProject = (file: unknown): boolean => versionOf(file, kind) !== undefined;

/** Reads a project. @throws {FileError} when the text is not a valid project */
export const readProject = (text: string, name: string): Project => readVersioned(text, name, kind);
