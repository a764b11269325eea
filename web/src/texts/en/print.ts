/** English texts of the print and the match. */

export const print = {
  controls: {
    fit: 'Cutting',
    presets: 'Starting points',
    presetNames: {
      homeSewist: 'Home sewist, on grain',
      wovenShirt: 'Woven shirt',
      bestFit: 'Best fit, any angle',
      placeOnly: 'Placing only, keep every outline',
    },
    presetNotes: {
      homeSewist: 'Pieces lie on grain and change by 10 mm at most.',
      wovenShirt:
        'Pieces lie on grain and change by 4 mm at most, so that collar and cuffs keep their cut.',
      bestFit: 'Pieces lie at any angle and change by 10 mm at most; the print meets best.',
      placeOnly: 'Pieces lie on grain and keep their outlines just as drafted.',
    },
    greatestChange: (unit: string) => `Greatest change (${unit})`,
    between: (least: string, most: string) => `Enter a number from ${least} to ${most}.`,
    grain: 'Grain for all pieces',
    grains: {on: 'On grain', across: 'Across', bias: 'On the bias', free: 'Any angle'},
    continuousOnly: 'Continue the print only',
    continuousNote: 'No mirrored seams: the print runs on across every one.',
    method: 'Method',
    methods: {
      best: 'Best',
      paper: 'Wolff et al. 2019',
      ws19: 'Wolff and Sorkine-Hornung 2019, without symmetry',
    },
    solveAsIGo: 'Solve as I go',
    unitNames: {cm: 'Centimetres', inch: 'Inches'},
    paperScale: 'Mismatch 0–2 cm, as in the paper',
  },
  print: {
    title: 'Print',
    open: 'Open print',
    photo: 'Photo of your cloth',
    own: (title: string) => `Your own: ${title}`,
    group: 'Wallpaper group',
    stripes: 'Stripes',
    more: 'More prints',
    ours: 'Prints that come with Seamwise',
    filter: 'Show only',
    filters: {
      botanical: 'Florals',
      geometric: 'Geometric',
      tailored: 'Stripes and checks',
      mirrors: 'With mirrors',
    },
    colourways: 'Colourways',
    width: (unit: string) => `Repeat width (${unit})`,
    height: (unit: string) => `Repeat height (${unit})`,
    proportions: 'Keep the proportions',
    sides: (width: string, height: string, turn: string) =>
      `The repeat on the cloth, whose length runs upwards: width ${width}, height ${height}, turned by ${turn}`,
    sideNames: {width: 'width', height: 'height'},
    fromFile: (resolution: string, size: string) => `From the file: ${resolution}, ${size} wide`,
    dpi: (value: string) => `${value} dpi`,
    onPaper: 'drawn to scale',
    backToFile: (resolution: string, size: string) =>
      `As large as the file says: ${resolution}, ${size} wide`,
    unasked: 'Many programs write this number by themselves: measure to be sure.',
    sizeUnknown: 'The file does not say how large it is printed: measure it, or enter a size.',
    unscaled: 'The size of this print is unknown: measure it or enter a size before you cut.',
    measure: {
      open: 'Measure on the picture',
      how: 'Click two points whose distance you know, or move them with the arrow keys.',
      points: ['First point', 'Second point'] as readonly string[],
      distance: (unit: string) => `Distance between them (${unit})`,
      makes: (width: string, height: string) => `One repeat is then ${width} × ${height}.`,
      apply: 'Use this size',
    },
    repeats: {
      label: 'How the picture repeats',
      straight: 'Straight',
      halfDrop: 'Half-drop',
      brick: 'Brick',
      mirrored: 'Mirrored',
      mirroredAcross: 'Mirrored sideways',
      mirroredUp: 'Mirrored up and down',
    },
    angle: 'Angle (degrees)',
    turn: 'Turn (degrees)',
    oneWay: 'Looks different upside down',
    oneWayNote: 'Does it look the same upside down? Then leave this off.',
    lacks: {
      piece: (group: string) =>
        `A piece that is symmetric in itself needs a print with mirrors, and ${group} has none.`,
      pair: (group: string) =>
        `A mirrored pair needs a print with mirrors or glides, and ${group} has neither.`,
    },
    wouldDo: 'These would do:',
    notQuite: (group: string, fitting: string) =>
      `Your cloth is not quite ${group}; ${fitting} still fits.`,
    take: (group: string) => `Take ${group}`,
    keep: (group: string) => `Keep ${group}`,
    needsPicture:
      'The picture of this print is in a file of its own: open that next, or drop it here.',
    keeps: 'Found in the picture:',
    reads: {
      picture: (how: string) => `This picture reads differently ${how}, where it is outlined.`,
      stripes: (how: string) => `These stripes read differently ${how}, where they are outlined.`,
    },
    differs: {
      leftRight: 'from left to right',
      topBottom: 'from top to bottom',
      diagonal: 'across a diagonal',
      slanted: 'across a slanted line',
      steps: 'when it is mirrored and moved on',
      upsideDown: 'upside down',
      quarterTurn: 'after a quarter turn',
      thirdTurn: 'after a third of a turn',
      sixthTurn: 'after a sixth of a turn',
      halfDrop: 'half a repeat aside',
    },
    has: 'This is what it has:',
    openEdges: {
      across: 'Its left and right edges do not meet.',
      up: 'Its upper and lower edges do not meet.',
      both: 'Its edges do not meet.',
    },
    marked: (title: string) => `${title}, with what does not match marked`,
    doubtful: (title: string) => `${title} does not repeat as it is.`,
    remedy: {
      label: 'What becomes of it',
      halfDrop: 'It is a half-drop',
      brick: 'It is a brick repeat',
      mirror: 'Mirror it',
      photo: 'It is a photo of cloth',
      another: 'Choose another',
      anyway: 'Use it anyway',
    },
    meanings: {
      p1: 'Repeats, without turns or mirrors.',
      p2: 'Looks the same upside down; no mirrors.',
      pm: 'Mirrors in one direction.',
      pg: 'Steps like footprints, mirrored and moved on.',
      cm: 'Mirrors in one direction, with the next row in half-drop.',
      pmm: 'Mirrors both ways.',
      pmg: 'Mirrors one way, steps like footprints the other.',
      pgg: 'Steps like footprints both ways.',
      cmm: 'Mirrors both ways, with the next row in half-drop.',
      p4: 'Looks the same after a quarter turn; no mirrors.',
      p4m: 'Mirrors both ways and along both diagonals, like a square tile.',
      p4g: 'Quarter turns, with mirrors along the diagonals between them.',
      p3: 'Looks the same after a third of a turn; no mirrors.',
      p3m1: 'Mirrors in three directions, through all turning points.',
      p31m: 'Mirrors in three directions, with turning points beside them, too.',
      p6: 'Looks the same after a sixth of a turn; no mirrors.',
      p6m: 'Mirrors in six directions, like a snow crystal.',
      stripes: 'Mirrors both ways; along the stripe any place is like any other.',
    },
    files: {
      tooLarge: (name: string) => `${name} is larger than 12 MB; make the picture smaller.`,
      tooWide: (name: string) =>
        `${name} has more than 8192 pixels along a side; make the picture smaller.`,
      outsidePictures: (name: string) =>
        `${name} takes in pictures from elsewhere, which browsers leave out; put them into the file, or save it as PNG.`,
      unreadable: (name: string) => `${name} cannot be read as a picture.`,
      kinds: {
        png: 'a PNG picture',
        jpeg: 'a JPEG picture',
        webp: 'a WebP picture',
        svg: 'an SVG drawing',
        gif: 'a GIF picture',
        heic: 'a HEIC photo',
        avif: 'an AVIF picture',
        tiff: 'a TIFF picture',
        bmp: 'a BMP picture',
        pdf: 'a PDF document',
        photoshop: 'a Photoshop file',
        postscript: 'a PostScript file',
        dxf: 'a DXF drawing',
        zip: 'a ZIP archive',
      },
      wrongKind: (name: string, kind: string) =>
        `${name} is ${kind}, which cannot be a print: save it as PNG or JPEG, and open that.`,
      damaged: (name: string, kind: string) =>
        `${name} is ${kind}, but damaged: save it again, or take another copy.`,
      pattern: (name: string) => `${name} is a sewing pattern, no print: use Open garment.`,
      openEdges: {
        across: (name: string) =>
          `${name} does not repeat: its left and right edges do not meet. Decide under Print what becomes of it.`,
        up: (name: string) =>
          `${name} does not repeat: its upper and lower edges do not meet. Decide under Print what becomes of it.`,
        both: (name: string) =>
          `${name} does not repeat: its edges do not meet. Decide under Print what becomes of it.`,
      },
      noPrint: (name: string) =>
        `${name} is no print: open a picture (PNG, JPEG, WebP, SVG), or a print file with group, w1 and w2.`,
      wrongLattice: (name: string, group: string) =>
        `In ${name}, w1 and w2 do not span a lattice of ${group}.`,
    },
  },
};

export type PrintTexts = typeof print;
