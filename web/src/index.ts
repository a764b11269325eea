/** The package for web pages: the solver in workers, and the file formats. */
export type {Alignment, MirrorMap, Point} from './model/geometry.js';
export * from './model/drape.js';
export * from './model/drape-file.js';
export * from './model/glb.js';
export type * from './model/garment.js';
export * from './model/garment-document.js';
export {garmentFile} from './model/garment-file.js';
export {garmentTitle, type GarmentTitle} from './model/garment-marks.js';
export type {LayNote, LayNoteCode} from './model/lay-note.js';
export type * from './model/lay-plan.js';
export * from './model/marker.js';
export type * from './model/options.js';
export type * from './model/grain.js';
export * from './model/print.js';
export * from './model/method.js';
export * from './model/problem.js';
export * from './model/notes.js';
export type * from './model/result.js';
export type * from './model/symmetries.js';
export {
  failureCodes,
  pageFailureCodes,
  SolverError,
  type Failure,
  type FailureCode,
} from './model/failure.js';

export {askedSymmetries, printOf} from './model/design.js';
export type {
  AskedSymmetry,
  Decisions,
  Design,
  DesignGarment,
  DesignPrint,
  DesignPrintFile,
  StoredFile,
} from './model/design.js';
export {problemOf, problemOfStored} from './model/design-problem.js';
export {LinkError, linkOf, readLink} from './model/link.js';
export type {LinkedGarment, LinkedPrint, LinkedProject} from './model/link.js';
export {FileError, isProject, readProject, writeProject} from './model/project.js';
export type {Project, ProjectView} from './model/project.js';
export {repeatOf, type RepeatSize} from './model/repeat.js';
export {tileRepeats, type PrintTile, type TileRepeat} from './model/print-tile.js';
export type {CellOf, Repeat} from './model/wallpaper.js';
export {resultText} from './model/result-text.js';
export {solvedDesign, type SolvedFiles} from './model/solved-design.js';
export * from './model/stored-design.js';

export * from './solver/client.js';
export * from './solver/main-thread.js';
export * from './solver/pool.js';
