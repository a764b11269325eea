/** The package for web pages: the solver in workers, and the file formats. */
export type {Alignment, MirrorMap, Point} from './model/geometry/vectors.js';
export * from './model/result/draped-garment.js';
export * from './model/documents/drape-file.js';
export * from './files/glb/glb.js';
export type * from './model/garment/specification.js';
export * from './model/garment/garment-document.js';
export {garmentFile} from './model/garment/write-garment.js';
export {garmentTitle, type GarmentTitle} from './model/garment/panel-marks.js';
export type {LayNote, LayNoteCode} from './model/result/lay-note.js';
export type * from './model/result/marker-plan.js';
export * from './model/result/marker-search.js';
export type * from './model/design/options.js';
export type * from './model/garment/grain.js';
export * from './model/print/repeating-print.js';
export {groupNames} from './model/base/core-tables.js';
export * from './model/result/method.js';
export * from './model/design/solve-problem.js';
export * from './model/result/notes.js';
export {printOfResult} from './model/result/print-of-result.js';
export type * from './model/result/result.js';
export type * from './model/garment/symmetries.js';
export {
  failureCodes,
  pageFailureCodes,
  photoFaults,
  SolverError,
  symmetryReasons,
  type Failure,
  type FailureCode,
} from './model/base/failure.js';

export {askedSymmetries, printOf} from './model/design/design.js';
export type {
  AskedSymmetry,
  Decisions,
  Design,
  DesignGarment,
  DesignPrint,
  DesignPrintFile,
  StoredFile,
} from './model/design/design.js';
export {problemOf, problemOfStored} from './model/documents/design-problem.js';
export {LinkError, linkOf, readLink} from './model/documents/link.js';
export type {LinkedGarment, LinkedPrint, LinkedProject} from './model/documents/link.js';
export {FileError} from './model/base/versioned-file.js';
export {isProject, readProject} from './model/documents/project.js';
export {writeProject} from './model/documents/write-project.js';
export type {Project, ProjectView} from './model/documents/write-project.js';
export {repeatOf, type RepeatSize} from './model/print/repeat.js';
export {tileRepeats, type PrintTile, type TileRepeat} from './model/print/opened-image.js';
export type {CellOf, Repeat} from './model/print/wallpaper.js';
export {resultText} from './model/documents/result-text.js';
export {solvedDesign, type SolvedFiles} from './model/design/solved-design.js';
export * from './model/documents/filed-design.js';
export * from './model/documents/stored-design.js';

export {chosenProblem} from './solver/search/asked-search.js';
export * from './solver/page-solvers.js';
export * from './solver/page-solvers.js';
export * from './solver/pool.js';
