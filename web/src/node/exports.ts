/** Types of the functions of `seamwise/node`, and writers of its files. */
export type {MarkerGarment} from '../model/design/marker-garment.js';
export type {Alignment, MirrorMap, Point} from '../model/geometry/vectors.js';
export * from '../model/result/draped-garment.js';
export type {
  Corners,
  DrapeFile,
  DrapeFileForm,
  DrapeFileMirror,
  DrapeFilePiece,
  DrapeFileSeam,
  DrapeFileSide,
  Place,
} from '../model/documents/drape-file.js';
export type {CellPicture, GlbOptions} from '../files/glb/glb.js';
export * from './documents.js';
export type {LayNote, LayNoteCode} from '../model/result/lay-note.js';
export type * from '../model/result/marker-plan.js';
export type * from '../model/garment/specification.js';
export type * from '../model/garment/garment-document.js';
export type * from '../model/design/options.js';
export type * from '../model/garment/grain.js';
export type * from '../model/print/photo-reading.js';
export type * from '../model/print/repeating-print.js';
export type * from '../model/result/method.js';
export type * from '../model/design/solve-problem.js';
export type {NoteCode, NoteDetail} from '../model/result/notes.js';
export type * from '../model/result/result.js';
export type * from '../model/garment/symmetries.js';
export type {
  NamedDrapeHooks as NodeDrapeHooks,
  NamedPrepareHooks as NodePrepareHooks,
  NamedProofHooks as NodeProofHooks,
  NamedSolveHooks as NodeSolveHooks,
  ProblemNames,
} from '../solver/requests/requests.js';
export {
  SolverError,
  type Failure,
  type FailureCode,
  type SymmetryReason,
} from '../model/base/failure.js';
export type {
  FiledDesign,
  FiledGarment,
  FiledPrint,
  PrintChanges,
} from '../model/documents/filed-design.js';
export type {StoredDesign} from '../model/documents/stored-design.js';
export type {StoredFile} from '../model/design/design.js';
export {FileError} from '../model/base/versioned-file.js';
export type {OwnShare} from '../cutting/allowances.js';
export type * from '../cutting/cut-sheet.js';
export type {PieceDxfOptions} from '../cutting/out/piece-dxf.js';
export type {DxfOptions} from '../cutting/out/sheet-dxf.js';
export type {DxfFormat, DxfStyle, DxfUnit} from '../model/base/dxf-format.js';
export type {LaidPrint} from '../marker/problem.js';
export type {PrintScale} from '../model/result/unscaled-print.js';
export type {MarkerSettings} from '../marker/settings.js';
export type {MarkerProgress, MarkerStage, Nap} from '../model/result/marker-search.js';
export type {Box} from '../model/geometry/polyline.js';
export type {PanelDecisions} from '../model/garment/panel-marks.js';
export type {CellPixels} from '../paper/fabric-cell.js';
export type {CuttingPdf} from '../paper/cutting-pdf.js';
export type {PageLayout, SheetPage} from '../paper/pages.js';
export type {Paper} from '../paper/papers.js';
export type {SheetMap} from '../paper/sheet-map.js';
export type {PrintWithTile} from '../picture/fabric.js';
export type {Cut, CutSettings} from './cut.js';
export type {
  ImportedGarment,
  ImportedPiece,
  ImportedSeam,
  ImportedSide,
  ImportOptions,
  ImportReport,
} from './import.js';
export type {ComparedSize} from '../solver/search/common-size.js';
export type {CommonSizeHooks} from './common-size.js';
export type {MarkerPlanHooks, NodeMarkerSettings} from './marker.js';
export type {LayPlanFiles, LayPlanSettings} from './lay-plan.js';
export type {PlanPdf} from '../marker/draw/plan-pdf.js';
export type {Order, OrderHooks} from './order.js';
export type {OrderRecord, OrderRecordSettings} from './order-record.js';
export type {RepeatForPrinting} from './repeat.js';
export type {Rectangle} from '../model/print/rectangular-repeat.js';
export type {PrintFromPixels, PrintFromPixelsSettings} from './photo.js';
export type {NamedEdge, SeamSuggestions, SuggestionSettings} from '../pairing/report.js';
export type {Remedy, RemedyChange, RemedyKind} from '../remedies/remedy.js';
