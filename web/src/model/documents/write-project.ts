/**
 * A design as a file, with the text of its garment, and with the print's image if it is the user's
 * own.
 */
import type {Design} from '../design/design.js';
import {written} from '../design/written-design.js';
import type {Point} from '../geometry/vectors.js';

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

export const format = 'seamwise-project';
export const version = 1;

export const writeProject = (design: Design, more: Omit<Project, 'design'> = {}): string =>
  JSON.stringify({format: `${format}/${version}`, design: written(design), ...more});
