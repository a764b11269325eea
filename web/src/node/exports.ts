/** Types of the functions of `seamwise/node`, and writers of its files. */
export type {Alignment, MirrorMap, Point} from '../model/geometry.js';
export * from '../model/drape.js';
export * from '../model/drape-file.js';
export * from '../model/glb.js';
export type {LayNote, LayNoteCode} from '../model/lay-note.js';
export type * from '../model/lay-plan.js';
export type * from '../model/garment.js';
export type * from '../model/garment-document.js';
export {garmentFile} from '../model/garment-file.js';
export type * from '../model/options.js';
export type * from '../model/grain.js';
export type * from '../model/photo.js';
export type * from '../model/print.js';
export type * from '../model/method.js';
export type * from '../model/problem.js';
export type {NoteCode, NoteDetail, SymmetryReason} from '../model/notes.js';
export type * from '../model/result.js';
export type * from '../model/symmetries.js';
export type {
  NamedDrapeHooks as NodeDrapeHooks,
  NamedPrepareHooks as NodePrepareHooks,
  NamedProofHooks as NodeProofHooks,
  NamedSolveHooks as NodeSolveHooks,
  ProblemNames,
} from '../solver/requests/texts.js';
export {SolverError, type Failure, type FailureCode} from '../model/failure.js';
export {problemOfStored} from '../model/design-problem.js';
export * from '../model/stored-design.js';
export type {StoredFile} from '../model/design.js';
export {resultText, sha256Of} from '../model/result-text.js';
export {FileError} from '../model/versioned-file.js';
export type {OwnShare} from '../cutting/allowances.js';
export type * from '../cutting/cut-sheet.js';
export type {DxfOptions} from '../cutting/out/sheet-dxf.js';
export {layPlanText} from '../marker/plan.js';
export type {MarkerGarment} from '../marker/pieces.js';
export type {LaidPrint} from '../marker/problem.js';
export type {PrintScale} from '../model/scaled.js';
export type {MarkerSettings} from '../marker/settings.js';
export type {MarkerProgress, MarkerStage, Nap} from '../model/marker.js';
export type {Box} from '../model/polyline.js';
export type {PanelDecisions} from '../model/garment-marks.js';
export type {CellPixels} from '../paper/cloth-cell.js';
export type {CuttingPdf} from '../paper/cutting-pdf.js';
export type {PageLayout, SheetPage} from '../paper/pages.js';
export type {Paper} from '../paper/papers.js';
export type {SheetMap} from '../paper/sheet-map.js';
export type {PrintWithTile} from '../picture/cloth.js';
export type {Cut, CutSettings} from './cut.js';
export type {
  ImportedGarment,
  ImportedPiece,
  ImportedSeam,
  ImportedSide,
  ImportOptions,
  ImportReport,
} from './import.js';
export type {MarkerPlanHooks, NodeMarkerSettings} from './marker.js';
export type {LayPlanFiles, LayPlanSettings} from './lay-plan.js';
export type {PlanPdf} from '../marker/draw/plan-pdf.js';
export type {Order, OrderHooks} from './order.js';
export type {PrintFromPixels, PrintFromPixelsSettings} from './photo.js';
export type {NamedEdge, SeamSuggestions, SuggestionSettings} from '../pairing/report.js';
export type {Remedy, RemedyChange, RemedyKind} from '../remedies/remedy.js';
