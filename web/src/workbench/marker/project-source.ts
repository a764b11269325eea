/** The stored projects of a page, whose garments can be added to a fabric. */
import type {Design} from '../../model/design/design.js';
import type {Workbench} from '../workbench.js';

export interface ProjectSource {
  readonly list: () => Promise<readonly {readonly id: string; readonly name: string}[]>;
  /** Undefined if the project no longer exists. */
  readonly designOf: (id: string) => Promise<Design | undefined>;
}

const sources = new WeakMap<Workbench, ProjectSource>();

export const offerProjects = (workbench: Workbench, source: ProjectSource): void => {
  sources.set(workbench, source);
};

export const projectsFor = (workbench: Workbench): ProjectSource | undefined =>
  sources.get(workbench);
