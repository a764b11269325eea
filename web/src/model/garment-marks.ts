/** What a garment says about its pieces that a result does not repeat. */
import type {GarmentDocument, GarmentPiece, Placement} from './garment-document.js';
import type {Point} from './geometry.js';
import {angleOf, type GrainRule} from './options.js';
import {pieceNames, titleOfFile, type PieceNames} from './piece-names.js';
import {fieldOf} from './read.js';

/** A mark on an edge of the outline, at a share of its length, between the ends of the edge. [cm] */
export interface Notch {
  readonly from: Point;
  readonly to: Point;
  readonly at: number;
}

export interface PanelMarks {
  /** What people call the piece. */
  readonly label: string;
  /** Of the face-up piece, as all that follows. [cm] */
  readonly grain?: readonly [Point, Point];
  /** Where the grain line was said to run, over the file: from the x axis. [degrees] */
  readonly grainDeg?: number;
  /** Where it is on the body. */
  readonly placement?: Placement;
  readonly notches?: readonly Notch[];
  /** All that the garment has of it. */
  readonly drafted?: GarmentPiece;
}

/** Of a garment's own words, those that belong on every sheet. */
export interface GarmentTitle {
  readonly title?: string;
  readonly size?: string;
}

/** What a person decided about panels, by their names, over what their file says. */
export interface PanelDecisions {
  readonly names?: PieceNames;
  readonly grain?: Readonly<Record<string, GrainRule>>;
}

/** The names that a garment's file, or a design, chooses for its pieces. */
export const chosenNames = (holder: unknown): PieceNames => {
  const names = fieldOf(holder, 'names');
  const entries = typeof names === 'object' && names !== null ? Object.entries(names) : [];
  return Object.fromEntries(
    entries.filter((entry): entry is [string, string] => typeof entry[1] === 'string'),
  );
};

/** By the name of the piece. */
export function panelMarks(
  document: Pick<GarmentDocument, 'pieces' | 'names'>,
  {names = {}, grain: rules = {}}: PanelDecisions = {},
): ReadonlyMap<string, PanelMarks> {
  const {pieces} = document;
  const labels = new Map(pieces.map(({name, label}) => [name, label]));
  const called = pieceNames(labels, {...chosenNames(document), ...names});
  return new Map(
    pieces.map((piece): [string, PanelMarks] => {
      const {name, outline, grain, placement, notches = []} = piece;
      const grainDeg = Object.hasOwn(rules, name) ? angleOf(rules[name]) : undefined;
      const marked = notches.flatMap(({edge, at}): Notch[] => {
        const {points} = outline[edge] ?? {};
        const to = points?.at(-1);
        return points && to ? [{from: points[0], to, at}] : [];
      });
      return [
        name,
        {
          label: called.get(name) ?? name,
          ...(grain?.line && {grain: grain.line}),
          ...(grainDeg !== undefined && {grainDeg}),
          ...(placement && {placement}),
          ...(marked.length > 0 && {notches: marked}),
          drafted: piece,
        },
      ];
    }),
  );
}

/** @param file the garment's, which is what it is called when it says no title itself */
export function garmentTitle(
  {title: said = '', size}: Pick<GarmentDocument, 'title' | 'size'>,
  file?: string,
): GarmentTitle {
  const isSaid = said.trim() !== '';
  const title = isSaid ? said : file === undefined ? undefined : titleOfFile(file);
  return {...(title !== undefined && {title}), ...(size !== undefined && {size})};
}
