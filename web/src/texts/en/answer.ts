/** English texts of the result: figures, notes, failures, remedies, lists and the element. */

export const answer = {
  headline: {
    fits: (mean: string) => `On average the print misses by ${mean} at the seams`,
    worst: (mean: string, seam: string) => `Worst ${mean}: ${seam}.`,
    before: (mean: string) => `Before, ${mean} on average.`,
    more: 'More figures',
    area: 'Length times mismatch',
    noSeams: 'No seams to match',
    fit: 'How well it meets',
    percentOfRandom: (percent: string) => `${percent} of pieces laid at random`,
    proven: 'No other placing fits better.',
    nearlyProven: (percent: string) => `No other placing fits more than ${percent} better.`,
    unproven: 'The best of all placings tried.',
    cost: 'What the symmetry costs',
    withSymmetry: 'With symmetry',
    withoutSymmetry: 'Without',
    notes: 'Notes',
  },
  /** Notes of the core on a result, by code. */
  notes: {
    noSeams: 'The file has no seams, so there is nothing to match.',
    noMatchedSeams: 'No seam is to be matched: each is switched off or joins a plain piece.',
    gathered: (seams: string) =>
      `One side is more than a tenth longer (gathers, pleats), so the print cannot match all along: ${seams}.`,
    unitsAssumed: 'The file does not say its units; centimetres are assumed.',
    curvesAssumed:
      'The file does not say how curves are written; relative control points are assumed.',
    lengthRatio: (seam: string, stated: string, drafted: string) =>
      `${seam}: by the file its sides are ${stated} to 1, drafted they are ${drafted} to 1; as drafted counts.`,
    noMirrors: (pieces: string, group: string) =>
      `A print of the group ${group} has no mirrors, so these are not kept symmetric: ${pieces}.`,
    noGlides: (pieces: string, group: string) =>
      `A print of the group ${group} has neither mirrors nor glides, so these pairs are not kept: ${pieces}.`,
    symmetriesStated: 'The symmetries are those that the file states.',
    ws19: 'This method knows no symmetry of the garment, so none is kept.',
    grainAssumed: (pieces: string) =>
      `The file has no grain line for these pieces, so upwards as drawn is assumed: ${pieces}.`,
    partOfTheWay:
      'The seams go only part of the way to their ideal lines; else outlines would cross or move too far.',
    leftAsDrafted:
      'No shape that the method found fits better than the pieces as drafted, so they keep their lines.',
    dropped: (pieces: string, why: string) => `The symmetry of ${pieces} is dropped: ${why}.`,
    cannotHold: (pieces: string, why: string) => `The symmetry of ${pieces} cannot hold: ${why}.`,
    why: {
      symmetryPins: 'as it is pinned, the print does not mirror so',
      symmetryGrain: 'on this print it would take pieces off their grain',
      symmetryChange: 'to mirror exactly, outlines would have to change by more than is allowed',
      symmetryKinks: 'to mirror exactly, outlines would get kinks or folds',
      symmetryLengths:
        'seams would lose their lengths, and the greatest change is too small for it',
      symmetryCrossing: 'the outline would cross itself',
      symmetrySewn: 'its edges are sewn to edges that do not mirror',
    },
  },
  /**
   * Failures of files. The core's sentences, which name the place in the file, are in English only.
   */
  failures: {
    garment: (message: string) => message,
    noGarment: (message: string) => message,
    solver: (message: string) => message,
    noWorker: (message: string) => message,
    noWasm: (message: string) => message,
    picture: (file: string) =>
      `${file} is a picture; open it as a print, or choose a sewing pattern.`,
    document: (file: string, kind: string) =>
      `${file} is ${kind}, which Seamwise cannot read: choose DXF, SVG, OBJ or a GarmentCode file for a pattern, or a PNG, JPEG, WebP or SVG picture for a print.`,
    tooLarge: (file: string) => `${file} is too large for a sewing pattern; choose another file.`,
    noDesign: (file: string) =>
      `${file} is a result without its design; open the garment that it was made from.`,
    project: (message: string) => message,
  },
  remedies: {
    title: (count: number) => (count === 1 ? 'One seam stays off' : `${count} seams stay off`),
    more: (count: number) => `and ${count} more`,
    help: 'What would help',
    why: {
      grain: 'its two sides cannot line up on grain',
      gather: 'one side is gathered',
      group: 'the print has no mirror for it',
      size: 'the print is too large for it',
      others: 'other seams of its pieces come first',
      locked: 'it is locked',
    },
    what: {
      turn: (pieces: string) => `Turn ${pieces} by 90°`,
      ungather: () => 'Leave out the gathers',
      mirrors: () => 'A print with mirrors',
      smaller: () => 'A print half as large',
    },
    effect: (before: string, after: string) => `${before} → ${after}`,
  },
  lists: {
    pieces: 'Pieces',
    seams: 'Seams',
    piece: 'Piece',
    moved: 'Moved',
    offGrain: 'Off grain',
    grain: 'Grain',
    printed: 'Printed',
    seam: 'Seam',
    length: 'Length',
    before: 'Before',
    after: 'After',
    match: 'Match',
    asAll: 'As all',
    pinned: 'Pinned',
    free: 'Free',
    matches: {double: 'Double', full: 'Full', half: 'Half', none: "Don't match"},
    weight: (factor: string) => `× ${factor}`,
    size: (width: string, height: string) => `${width} × ${height}`,
    worst: (length: string) => `worst ${length}`,
    runsOff: (length: string) => `meets at one end, ${length} off at the other`,
    offAlong: (length: string) => `followed all along, up to ${length} off`,
    lost: 'the print does not run on along it',
    between: (a: string, b: string) => `${a} to ${b}`,
    within: (piece: string) => `${piece}, within the piece`,
    numbered: (name: string, number: number) => `${name} ${number}`,
    of: (what: string, whose: string) => `${what}: ${whose}`,
    unknown: 'not known yet',
    rename: 'Rename',
    name: 'Name of the piece',
    nameTaken: (name: string) =>
      `Another piece is called ${name}; give this one a name of its own.`,
    quarterTurn: 'Turn by 90 degrees',
    turned: (piece: string) => `${piece} turned by 90 degrees.`,
  },
  lens: {
    label: 'Seam lens',
    description: 'Up and down arrow keys go to the seams that miss more and less, Escape unpins.',
    none: 'No seam to show yet.',
    nextWorst: 'Next worst seam',
    previousWorst: 'Previous worst seam',
    pin: 'Pin',
    widen: 'Enlarge',
    rank: (rank: number, count: number) => `${rank} of ${count}`,
    mismatch: (before: string, after: string) => `Mismatch ${before} before, ${after} after`,
    ruler: (length: string) => `One tick is ${length}`,
  },
  garment: {
    label: 'Sewing pattern in its print',
    required: 'The print is not fitted yet; wait until it is, or choose another.',
    prints: 'Prints',
    scale: (unit: string) => `Repeat width (${unit})`,
    noGarment: 'There is nothing to show: name a garment and a print.',
    noSize: (url: string) => `${url} has a place for a size; name one in the attribute 'size'.`,
    noAddress: (url: string) => `${url} is no address; correct it.`,
    notFound: (url: string) => `${url} is not there; correct the address, or put the file there.`,
    network: (url: string, reason: string) =>
      `${url} cannot be read (${reason}); check the connection and the host.`,
    timeout: (url: string, seconds: string) =>
      `${url} was not read within ${seconds} s; try again.`,
    tooLarge: (url: string, most: string) => `${url} is larger than ${most}; choose a smaller one.`,
    noPrint: (url: string) =>
      `${url} is no print file; give a picture as part of a print, with group, w1 and w2.`,
    notJson: (url: string) => `${url} is not JSON; choose another file.`,
    noSymmetries: (url: string) => `${url} holds no list of symmetries; correct it.`,
    notAnImage: (url: string) => `${url} cannot be read as a picture; choose another.`,
    fileChanged: (url: string) =>
      `${url} is not the file that the design was made with; put the earlier one back, or make the design again.`,
    notStorable: (what: string) =>
      `The ${what} was given as an object; give its URL, so that the design can be stored.`,
    garment: 'garment',
    print: 'print',
    noAnswer: 'There is no answer to store yet; wait for it with solve().',
    noCloth:
      "There is nothing to lay on: say how wide the cloth is, in the attribute 'cloth-width'.",
    noDrawing: 'Nothing is drawn yet; wait for it with solve().',
    pictureWidth: (most: string) => `A picture is 1 to ${most} pixels wide; ask for one of these.`,
    allowance: (most: string) => `An allowance is 0 to ${most}; ask for one of these.`,
    noPicture: 'This browser cannot write the picture; ask for a smaller one.',
    noTools: (reason: string) =>
      `What this needs cannot be loaded (${reason}); check the connection and load the page again.`,
    cancelled: 'The solve was cancelled.',
  },
};

export type AnswerTexts = typeof answer;
