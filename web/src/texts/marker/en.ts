/** English texts of the fabric layout. */

/** An ordinal number: 1st, 2nd, 3rd, 4th, 11th, 21st. */
function ordinal(n: number): string {
  const teens = n % 100 > 10 && n % 100 < 14;
  const ending = teens ? 'th' : (['th', 'st', 'nd', 'rd'][n % 10] ?? 'th');
  return `${n}${ending}`;
}

export const cloth = {
  label: 'Cloth with the pieces on it',
  description:
    'Arrow keys move the selected piece to the next free place, with Alt to the next place even where others lie; R turns it, P pins it, Delete takes it off, N and Shift N go from piece to piece, plus and minus zoom, 0 shows all. Shift X adds a flaw in the middle, which the arrow keys then move.',
  panel: 'Cloth',
  /** The length to buy. */
  buy: (length: string) => `Buy ${length}`,
  /** Replaces the length to buy while pieces are unplaced. */
  notLying: (count: number) =>
    count === 1 ? '1 piece does not lie yet' : `${count} pieces do not lie yet`,
  notWell: (count: number) =>
    count === 1
      ? '1 piece cannot be cut where it lies'
      : `${count} pieces cannot be cut where they lie`,
  metres: (metres: string) => `${metres} m`,
  yards: (yards: string) => `${yards} yd`,
  used: (length: string, percent: string) => `${length} long, ${percent} used`,
  lying: (length: string, percent: string) => `The others lie on ${length}, ${percent} used`,
  proven: 'Proven shortest',
  provenPinned: 'Proven shortest around what is pinned',
  bound: (length: string) => `At best ${length}`,
  moved: 'As moved by hand',
  costs: (length: string) => `The print costs ${length}`,
  costsNothing: 'The print costs no cloth',
  pinsCost: (length: string) => `Your pins cost ${length} more`,
  pinsCostNothing: 'Your pins cost no cloth',
  costsPinned: (length: string) => `The print and your pins together cost ${length}`,
  range: (least: string, most: string) =>
    `${least} to ${most}, depending on where the print starts: measure it.`,
  rangeNowhere: (nowhere: number, all: number) =>
    `At ${nowhere} of ${all} places where the print may start, not all pieces fit.`,
  /** Suggestions that save fabric. */
  less: {
    phase: (saving: string, start: string) =>
      `${saving} less if the print starts ${start} from the left edge`,
    shift: (saving: string, pieces: string) =>
      `${saving} less if the print may move under ${pieces}`,
    unmatched: (saving: string, pieces: string) =>
      `${saving} less if the print need not match on ${pieces}`,
  },
  lessDesign: (saving: string, mean: string, instead: string) =>
    `${saving} less with another placing in the print that fits as well: off by ${mean} instead of ${instead} on average`,
  takeDesign: 'Place it so',
  width: 'Cloth width',
  otherWidth: 'Other …',
  widthIn: (unit: string) => `Cloth width (${unit})`,
  selvedge: (unit: string) => `Selvedge (${unit})`,
  gap: (unit: string) => `Between pieces (${unit})`,
  copies: 'Garments',
  allowances: (seam: string, hem: string) => `Seam allowance ${seam}, hems ${hem}`,
  changeAllowances: 'Change',
  allowance: (unit: string) => `Seam allowance (${unit})`,
  hem: (unit: string) => `Hem (${unit})`,
  ownAllowances: {
    all: 'The pattern has its own allowances on all edges.',
    some: 'The pattern has its own allowances on some edges.',
  },
  oneWay: 'All pieces one way up',
  oneWayNote: 'For velvet and other cloth with a nap.',
  oneWayPrint: 'This print has a right way up.',
  phase: 'Print starts at the selvedge',
  phases: {unknown: 'Unknown', known: 'Measured'},
  phaseIn: (unit: string) => `From the left edge to a corner of the repeat (${unit})`,
  widths: 'On other widths',
  /** Notes on the table of widths for layouts with moved or pinned pieces. */
  widthsOf: {
    packed: 'Lengths of all pieces, packed anew',
    unpinned: 'Lengths of all pieces, packed anew with none pinned',
  },
  widthColumn: 'Width',
  lengthColumn: 'Length',
  nowhere: 'does not fit',
  takeWidth: (width: string) => `Lay on ${width}`,
  pieces: 'Pieces on the cloth',
  piece: 'Piece',
  place: 'Place',
  at: (across: number, along: number) =>
    `${ordinal(across)} repeat from the left, ${ordinal(along)} from the start`,
  atLength: (left: string, start: string) => `${left} from the left, ${start} from the start`,
  atRow: (across: number, start: string) =>
    `${ordinal(across)} repeat from the left, ${start} from the start`,
  turned: (degrees: string) => `turned ${degrees}°`,
  farther: (length: string) => `moved ${length}, as nearer places are not free`,
  noPlace: 'not on the cloth',
  takeOff: 'Take off the cloth',
  takenOff: (piece: string) => `${piece} is off the cloth; packing brings it back.`,
  pinned: 'pinned',
  pin: 'Pin',
  unpin: 'Unpin',
  turn: 'Turn',
  pinPiece: (piece: string) => `Pin ${piece}`,
  cannotTurn: (piece: string) => `${piece} has no other turn on this print and grain.`,
  noTurnNear: (piece: string, reach: string) =>
    `${piece} stays as it lies: turned, it has no free place within ${reach}.`,
  noWay: (piece: string) => `${piece} has no free place further on that way.`,
  packRest: 'Pack the rest',
  packAgain: 'Pack again',
  overlaps: (piece: string, others: string) => `${piece} overlaps ${others}`,
  onFlaw: (piece: string) => `${piece} lies on a flaw`,
  outside: (piece: string) => `${piece} reaches beyond the cloth`,
  flaw: 'Mark a flaw',
  flawHint: 'Drag a box over the flaw, or click its corners and press Enter; Esc ends.',
  flaws: 'Flaws',
  flawAt: (number: number, left: string, start: string) =>
    `Flaw ${number}, ${left} from the left, ${start} from the start`,
  addFlaw: 'Add a flaw',
  flawKeys:
    'Arrow keys move a flaw in the list, with Shift they make it larger or smaller; Delete removes it.',
  flawSize: (width: string, length: string) => `${width} wide, ${length} long`,
  flawRemoved: (number: number) => `Flaw ${number} is removed.`,
  flawFields: {
    left: (unit: string) => `From the left edge (${unit})`,
    start: (unit: string) => `From the start (${unit})`,
    width: (unit: string) => `Width (${unit})`,
    length: (unit: string) => `Length (${unit})`,
  },
  remove: 'Remove',
  removeFlaw: (flaw: string) => `Remove: ${flaw}`,
  savePlan: 'Save lay plan (JSON)',
  saveSvg: 'Save lay plan (SVG)',
  savePdf: 'Save lay plan (PDF)',
  savePlotter: 'Save lay plan at true scale (PDF)',
  saveDxf: 'Save lay plan (DXF)',
  cutEdge: 'cut edge',
  selvedgeLabel: 'selvedge',
  printStarts: 'print starts',
  laying: (percent: string) => `Laying, ${percent}`,
  cancel: 'Cancel',
  cancelled: 'Cancelled: it may become shorter.',
  again: 'Lay again',
  waiting: 'Laid once the print is aligned',
  stale: 'The design has changed: this is the plan from before.',
  toSize: 'Enter its size',
  hint: 'Drag a piece to another place in the print',
  nextPiece: 'Next piece',
  pieceBefore: 'Piece before',
  deleteKey: 'Delete',
  keys: {
    move: 'Move the piece to the next free place',
    moveOnto: 'The same, even where others lie',
    turnOnto: 'Turn the piece, even where others lie',
    leave: 'End what is under way; no piece is selected',
    closeFlaw: 'Close the outline of a flaw',
    sizeFlaw: 'Make the chosen flaw larger or smaller; arrows alone move it, Delete removes it',
  },
  steps: {
    move: 'move on the cloth',
    turn: 'turn on the cloth',
    remove: 'taking off the cloth',
    pin: 'pin on the cloth',
    pack: 'packing',
    flaw: 'flaw',
    cloth: 'cloth',
  },
};

export type ClothTexts = typeof cloth;
