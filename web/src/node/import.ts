/** Imports patterns of other programs as garments, with a report. */
import {grainDeg} from '../model/garment/grain.js';
import {drawingLimit, readAnyDrawing} from '../files/read-drawing.js';
import {
  defaultChoices,
  drawnPieceInCm,
  garmentOf,
  type DefaultChoices,
} from '../files/to-garment.js';
import {cmPer, isPossible} from '../files/base/units.js';
import type {Drawing, DrawingOptions} from '../model/garment/imported-drawing.js';
import {edgeLine} from '../model/garment/edge-curve.js';
import {
  unitsInMetre,
  type EdgeOfPiece,
  type FileUnit,
  type GarmentDocument,
  type GarmentPiece,
} from '../model/garment/garment-document.js';
import {garmentFile, inUnit} from '../model/garment/write-garment.js';
import {angleOf, degrees, minus, type Point} from '../model/geometry/vectors.js';
import {boxOf, signedArea} from '../model/geometry/polyline.js';
import {fieldOf} from '../model/base/read.js';
import {FileError} from '../model/base/versioned-file.js';
import {textOf} from './files.js';

export {drawingLimit};

/** Segments per curve for measuring a piece, which give areas to 0.1 cm2. */
const areaSteps = 128;

export interface ImportOptions {
  /** File name for messages. */
  readonly name?: string;
  /** Unit of the file, which overrides the stated one. */
  readonly units?: FileUnit;
  /** Pixels per inch of an SVG file, instead of `units`. */
  readonly pixelsPerInch?: number;
  /** Denominator of the scale 1 : n of a reduced drawing. Default 1. */
  readonly scale?: number;
  /** Sets the scale by the longer side of a piece. [cm] */
  readonly measured?: {readonly piece: string; readonly longerCm: number};
  /** Size of a nest. Default: the sample size, from which others were graded. */
  readonly size?: string;
  /** Pages of a PDF, by their numbers from 1. Default: those that show the pattern. */
  readonly pages?: readonly number[];
  /** Columns and rows of the pages of a PDF, in reading order. Default: by their lines and names. */
  readonly grid?: readonly [columns: number, rows: number];
  /** Strip at each side of the pages of a PDF that is cut off. Default: by their lines. [cm] */
  readonly trimCm?: number;
  /** Overlap of neighbouring pages of a PDF, after trimming. Default: by their lines. [cm] */
  readonly overlapCm?: number;
  /** Seam allowance that the lines of a PDF include; 0 if they are sewn lines, the default. [cm] */
  readonly allowanceCm?: number;
  /**
   * Source of the seams: `suggest`, the default, adds suggestions if the file has none; `file` uses
   * only the file; `none` omits them.
   */
  readonly seams?: 'suggest' | 'file' | 'none';
}

export interface ImportedPiece {
  readonly name: string;
  readonly widthCm: number;
  readonly heightCm: number;
  readonly areaCm2: number;
  /** Number of pieces to cut, including mirror images. */
  readonly quantity: number;
  readonly notches: number;
  /** Angle of the grain line, counter-clockwise from the x axis; null without one. */
  readonly grainDeg: number | null;
  /** All grain lines, if the piece has several; `align --grain-line` chooses one. */
  readonly grains?: readonly {readonly name?: string; readonly angleDeg: number}[];
  /** True if the file draws half of the piece, up to a fold. */
  readonly fold: boolean;
  /** True if the file draws the sewn line and the cut line. */
  readonly sewLine: boolean;
  readonly cutLine: boolean;
  /** False for omitted pieces; notes give the reason. */
  readonly taken: boolean;
}

/** A part of an outline, from point to point in sewing order. [cm] */
export interface ImportedSide {
  readonly piece: string;
  readonly from: Point;
  readonly to: Point;
}

export interface ImportedSeam {
  readonly a: ImportedSide;
  readonly b: ImportedSide;
  /** True if the start of one edge meets the end of the other. */
  readonly reversed: boolean;
  /** Probability of a suggested seam; 1 for seams of the file. */
  readonly score: number;
}

export interface ImportReport {
  readonly pieces: readonly ImportedPiece[];
  readonly sizes: readonly string[];
  readonly size: string | null;
  readonly units: {readonly used: string; readonly from: 'file' | 'flag' | 'guess'};
  readonly seams: readonly ImportedSeam[];
  /** Assumptions and omissions, one sentence each. */
  readonly notes: readonly string[];
}

export interface ImportedGarment {
  /** The text of a seamwise-garment/1 file. */
  readonly garment: string;
  readonly report: ImportReport;
}

/** Reads and checks the text of a garment. */
type ReadGarment = (text: string, name: string) => Promise<GarmentDocument>;

/**
 * Imports a pattern file.
 * @throws {FileError} or {SolverError} under the conditions of `importGarment`
 */
export async function importWith(
  readGarment: ReadGarment,
  bytes: Uint8Array,
  {name = 'the pattern', seams = 'suggest', measured: known, ...reading}: ImportOptions,
): Promise<ImportedGarment> {
  const isJson = /^\s*\{/.test(textOf(bytes.subarray(0, 64)));
  const {document, found} = isJson
    ? await fromGarment(readGarment, textOf(bytes), name, reading.units)
    : await fromDrawing(readGarment, bytes, name, {
        ...reading,
        ...(known && {scale: await scaleBy(known, bytes, name, reading)}),
      });
  const isAsked = seams === 'suggest' && document.seams.length === 0;
  const sewn = isAsked ? await withSuggestions(document) : document;
  const kept = seams === 'none' ? {...document, seams: []} : sewn;
  const notes = isAsked ? [...found.notes, ...(await unsuggested(document))] : found.notes;
  return {
    garment: garmentFile(kept),
    report: {...found, notes, seams: kept.seams.map((seam) => seamIn(kept, seam))},
  };
}

/** A note if the garment has too many edges for suggestions. */
async function unsuggested({pieces}: GarmentDocument): Promise<readonly string[]> {
  const {mostScoredEdges} = await import('../pairing/scores.js');
  const edges = pieces.reduce((sum, {outline}) => sum + outline.length, 0);
  return edges > mostScoredEdges
    ? [
        `No seams are suggested: the pieces have ${edges} edges, and at most ${mostScoredEdges} can be compared; import fewer pieces.`,
      ]
    : [];
}

/** Adds nearly certain seams, marked as suggested. */
async function withSuggestions(document: GarmentDocument): Promise<GarmentDocument> {
  const {sureSeams} = await import('../pairing/suggest.js');
  const seams = sureSeams(document).map(({a, b, p, sameDirection}) => ({
    ...{a, b, sameDirection, weight: 1, matched: true, suggested: true as const},
    more: {score: rounded(p)},
  }));
  return {...document, seams};
}

interface Found {
  readonly document: GarmentDocument;
  readonly found: Omit<ImportReport, 'seams'>;
}

async function fromGarment(
  readGarment: ReadGarment,
  text: string,
  name: string,
  units: FileUnit | undefined,
): Promise<Found> {
  const document = await readGarment(text, name);
  const read = units ? await readGarment(inUnit(text, units), name) : document;
  const perMetre = fieldOf(fieldOf(JSON.parse(text) as unknown, 'properties'), 'units_in_meter');
  const [used] = Object.entries(unitsInMetre).find(([, count]) => count === perMetre) ?? ['cm'];
  return {
    document: read,
    found: {
      pieces: read.pieces.map((piece) => ({...measured(piece), taken: true})),
      sizes: read.size === undefined ? [] : [read.size],
      size: read.size ?? null,
      units: units ? {used: shortly(units), from: 'flag'} : {used: shortly(used), from: 'file'},
      notes: [],
    },
  };
}

/** The unit as in the command line's flag. */
const shortly = (unit: string): string => (unit === 'inch' ? 'in' : unit);

async function fromDrawing(
  readGarment: ReadGarment,
  bytes: Uint8Array,
  name: string,
  options: DrawingOptions,
): Promise<Found> {
  const drawing = await readAnyDrawing(bytes, name, options);
  const choices = await soundChoices(readGarment, drawing, name);
  const drawn = garmentOf(drawing, choices);
  const {unit, because} = drawing.unit;
  const {units, pixelsPerInch, scale} = options;
  const isAsked = [units, pixelsPerInch, scale].some((one) => one !== undefined);
  const pieces = piecesIn(drawing, choices, drawn);
  const largest = Math.max(...pieces.map(({widthCm, heightCm}) => Math.max(widthCm, heightCm)));
  const guess = because === 'size' || !drawing.unit.isSure;
  if (!isAsked && !isPossible(largest)) {
    throw new FileError(
      name,
      `would have a largest piece of ${largest.toPrecision(3)} cm if it is in ${unit}, which nobody could wear; say in which unit it is with --units mm, cm or in${drawing.kind === 'svg' ? ', or pixels per inch, such as 300ppi' : ''}.`,
    );
  }
  if (drawn.pieces.length === 0) {
    throw new FileError(name, `has no piece to print: ${choices.notes.join(' ')}`);
  }
  const document = await readGarment(garmentFile(drawn), name);
  return {
    document,
    found: {
      pieces,
      sizes: drawing.sizes,
      size: drawing.size ?? null,
      units: {
        used: pixelsPerInch === undefined ? shortly(unit) : `${pixelsPerInch}ppi`,
        from: isAsked ? 'flag' : guess ? 'guess' : 'file',
      },
      notes: [
        ...drawing.notes,
        ...choices.notes,
        ...(guess && !isAsked
          ? [
              `The unit is taken to be ${shortly(unit)}, in which the largest piece is ${largest.toFixed(1)} cm long.`,
            ]
          : []),
      ],
    },
  };
}

/**
 * The scale at which a piece has a length.
 * @throws {FileError} if there is no such piece
 */
async function scaleBy(
  {piece, longerCm}: NonNullable<ImportOptions['measured']>,
  bytes: Uint8Array,
  name: string,
  options: DrawingOptions,
): Promise<number> {
  const drawing = await readAnyDrawing(bytes, name, options);
  const choices = defaultChoices(drawing);
  const pieces = piecesIn(drawing, choices, garmentOf(drawing, choices));
  const found = pieces.find((one) => one.name === piece);
  if (!found) {
    const names = pieces.map((one) => one.name).join(', ');
    throw new FileError(name, `has no piece '${piece}' to measure; its pieces are ${names}.`);
  }
  return ((options.scale ?? 1) * longerCm) / Math.max(found.widthCm, found.heightCm);
}

/** The default choices, without pieces that no garment can have. A note names each of them. */
async function soundChoices(
  readGarment: ReadGarment,
  drawing: Drawing,
  name: string,
): Promise<DefaultChoices> {
  const choices = defaultChoices(drawing);
  const complaint = async (pieces: DefaultChoices['pieces']): Promise<string | undefined> => {
    const garment = garmentOf(drawing, {...choices, pieces});
    if (garment.pieces.length === 0) return undefined;
    try {
      await readGarment(garmentFile(garment), name);
      return undefined;
    } catch (error) {
      return error instanceof Error ? error.message : String(error);
    }
  };
  if ((await complaint(choices.pieces)) === undefined) return choices;
  const notes: string[] = [];
  const pieces = [...choices.pieces];
  for (const [k, choice] of choices.pieces.entries()) {
    if (!choice.take) continue;
    const why = await complaint(choices.pieces.map((one, other) => ({...one, take: other === k})));
    if (why === undefined) continue;
    pieces[k] = {...choice, take: false};
    notes.push(`Piece '${drawing.pieces[k]?.name ?? ''}' is left out: ${why}`);
  }
  const isNoneLeft = pieces.every(({take}) => !take);
  return isNoneLeft ? choices : {...choices, pieces, notes: [...choices.notes, ...notes]};
}

/** All drawn pieces, including omitted ones. */
function piecesIn(
  drawing: Drawing,
  {unit, pieces: choices}: DefaultChoices,
  {pieces, symmetries}: GarmentDocument,
): ImportedPiece[] {
  const folded = new Set(symmetries.flatMap((one) => (one.kind === 'piece' ? [one.piece] : [])));
  let next = 0;
  return drawing.pieces.map((drawn, k): ImportedPiece => {
    const {take, cut} = choices[k] ?? {take: false, cut: 'once'};
    const own = take ? pieces[next] : undefined;
    if (take) next += cut === 'pair' ? 2 : 1;
    const {asDrawn, mirrored} = drawn.quantity;
    const isBoth = drawn.cut !== undefined;
    return {
      ...measured(own ?? drawnPieceInCm(drawn, cmPer(unit))),
      quantity: asDrawn + mirrored,
      fold: own !== undefined && folded.has(own.name),
      ...{sewLine: isBoth, cutLine: isBoth, taken: take},
    };
  });
}

function measured(piece: GarmentPiece): Omit<ImportedPiece, 'taken'> {
  const outline = piece.outline.flatMap((edge) => edgeLine(edge, areaSteps).slice(0, -1));
  const {low, high} = boxOf(outline);
  const line = piece.grain?.line;
  return {
    name: piece.name,
    widthCm: rounded(high[0] - low[0]),
    heightCm: rounded(high[1] - low[1]),
    areaCm2: rounded(Math.abs(signedArea(outline))),
    quantity: piece.quantity ?? 1,
    notches: piece.notches?.length ?? 0,
    grainDeg: line ? rounded(degrees(angleOf(minus(line[1], line[0])))) : null,
    ...(piece.grains && {
      grains: piece.grains.map((one) => ({
        ...(one.name !== undefined && {name: one.name}),
        angleDeg: rounded(grainDeg(one)),
      })),
    }),
    fold: false,
    sewLine: piece.sewLine !== undefined,
    cutLine: piece.cutLine !== undefined,
  };
}

const rounded = (value: number): number => Number(value.toFixed(4)) + 0;

function seamIn(
  {pieces}: GarmentDocument,
  {a, b, sameDirection, more}: GarmentDocument['seams'][number],
): ImportedSeam {
  const side = ({piece, edge}: EdgeOfPiece, isTurned: boolean): ImportedSide => {
    const {name = '', outline = []} = pieces[piece] ?? {};
    const points: readonly Point[] = outline[edge]?.points ?? [];
    const ends = [points[0] ?? [0, 0], points.at(-1) ?? [0, 0]] as const;
    return {piece: name, from: ends[isTurned ? 1 : 0], to: ends[isTurned ? 0 : 1]};
  };
  const score = fieldOf(more, 'score');
  return {
    ...{a: side(a, false), b: side(b, !sameDirection), reversed: !sameDirection},
    score: typeof score === 'number' ? score : 1,
  };
}
