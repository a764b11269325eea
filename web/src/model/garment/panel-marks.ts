/** Properties of a garment's pieces that a result does not repeat. */
import type {GarmentDocument, GarmentPiece, Placement} from './garment-document.js';
import type {Point} from '../geometry/vectors.js';
import {angleOf, grainInUse, type GrainRule} from './grain.js';
import {pieceNames, titleOfFile, type PieceNames} from './piece-names.js';
import {fieldOf} from '../base/read.js';

/** A mark on an edge of the outline, at a share of its length, with the ends of the edge. [cm] */
export interface Notch {
  readonly from: Point;
  readonly to: Point;
  readonly at: number;
}

export interface PanelMarks {
  /** Name of the piece for the user. */
  readonly label: string;
  /** Grain line. It and all following members refer to the face-up piece. [cm] */
  readonly grain?: readonly [Point, Point];
  /**
   * Chosen direction of the grain line, from the x axis; it overrides the one in the file.
   * [degrees]
   */
  readonly grainDeg?: number;
  /** Name of the chosen grain line, if the maker draws several. */
  readonly grainName?: string;
  /** Placement on the body. */
  readonly placement?: Placement;
  readonly notches?: readonly Notch[];
  /** The piece in the garment document. */
  readonly drafted?: GarmentPiece;
}

/** Title and size of a garment, which appear on every sheet. */
export interface GarmentTitle {
  readonly title?: string;
  readonly size?: string;
}

/** The user's decisions about panels, by their names; they override the file. */
export interface PanelDecisions {
  readonly names?: PieceNames;
  readonly grain?: Readonly<Record<string, GrainRule>>;
}

/** Names of pieces chosen by a garment file or a design. */
export const chosenNames = (holder: unknown): PieceNames => {
  const names = fieldOf(holder, 'names');
  const entries = typeof names === 'object' && names !== null ? Object.entries(names) : [];
  return Object.fromEntries(
    entries.filter((entry): entry is [string, string] => typeof entry[1] === 'string'),
  );
};

/** Marks of all panels, by the name of the piece. */
export function panelMarks(
  document: Pick<GarmentDocument, 'pieces' | 'names'>,
  {names = {}, grain: rules = {}}: PanelDecisions = {},
): ReadonlyMap<string, PanelMarks> {
  const {pieces} = document;
  const labels = new Map(pieces.map(({name, label}) => [name, label]));
  const called = pieceNames(labels, {...chosenNames(document), ...names});
  return new Map(
    pieces.map((piece): [string, PanelMarks] => {
      const {name, outline, placement, notches = []} = piece;
      const chosenDeg = Object.hasOwn(rules, name) ? angleOf(rules[name]) : undefined;
      const marked = notches.flatMap(({edge, at}): Notch[] => {
        const {points} = outline[edge] ?? {};
        const to = points?.at(-1);
        return points && to ? [{from: points[0], to, at}] : [];
      });
      return [
        name,
        {
          label: called.get(name) ?? name,
          ...grainUsed(piece, chosenDeg),
          ...(placement && {placement}),
          ...(marked.length > 0 && {notches: marked}),
          drafted: piece,
        },
      ];
    }),
  );
}

/** The grain line in use, and its name if the maker draws several. */
function grainUsed(
  piece: Pick<GarmentPiece, 'grain' | 'grains'>,
  chosenDeg: number | undefined,
): Pick<PanelMarks, 'grain' | 'grainDeg' | 'grainName'> {
  const used = grainInUse(piece, chosenDeg);
  const line = used?.line ?? piece.grain?.line;
  const deg = chosenDeg ?? (line ? undefined : used?.angleDeg);
  return {
    ...(line && {grain: line}),
    ...(deg !== undefined && {grainDeg: deg}),
    ...(used?.name !== undefined && {grainName: used.name}),
  };
}

/** Title and size of a garment. @param file name of its file, for a garment without a title */
export function garmentTitle(
  {title: said = '', size}: Pick<GarmentDocument, 'title' | 'size'>,
  file?: string,
): GarmentTitle {
  const isSaid = said.trim() !== '';
  const title = isSaid ? said : file === undefined ? undefined : titleOfFile(file);
  return {...(title !== undefined && {title}), ...(size !== undefined && {size})};
}
