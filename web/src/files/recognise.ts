/** Recognises file types by content, regardless of the name, and explains unsupported ones. */
import type {Refusal} from '../model/base/versioned-file.js';
import {decoded} from './base/decoded.js';

export type DrawingKind = 'dxf' | 'svg' | 'obj' | 'pdf';

/** The start of a file. */
interface Beginning {
  readonly bytes: Uint8Array;
  /** The first characters. */
  readonly text: string;
}

/** Number of characters examined. */
const looked = 16_384;

interface Recognised {
  readonly is: (file: Beginning) => boolean;
  readonly kind: DrawingKind | Refusal;
}

const starts =
  (...marks: readonly string[]): Recognised['is'] =>
  ({bytes}) =>
    marks.some((mark) => String.fromCharCode(...bytes.subarray(0, mark.length)) === mark);

const says =
  (pattern: RegExp): Recognised['is'] =>
  ({text}) =>
    pattern.test(text);

const picture = (what: string): Refusal => ({
  refusal: `is a ${what} picture, whatever it is called; open it as a print, or export the pattern as DXF or SVG.`,
  reason: 'picture',
});

const model: Refusal = {
  refusal:
    'is a 3D model without flat pieces; export it as OBJ with UVs, or its pattern as DXF (AAMA or ASTM).',
  reason: 'model',
};

const illustrator: Refusal = {
  refusal: "is Adobe Illustrator's own format; there, use File > Save a Copy, and choose SVG.",
  reason: 'illustrator',
};

/** The first match counts. */
const kinds: readonly Recognised[] = [
  {
    is: starts('AutoCAD Binary DXF'),
    kind: {refusal: 'is a binary DXF; save it as ASCII DXF.', reason: 'binary'},
  },
  {
    is: says(/^(\s*999\s*[\r\n].*[\r\n]+)*\s*0\s*[\r\n]+\s*SECTION\s/),
    kind: 'dxf',
  },
  {
    is: says(/^AC10\d\d|^AC1\.|^MC0\.0/),
    kind: {
      refusal: 'is DWG, which only CAD programs read; there, save it as ASCII DXF (R12).',
      reason: 'binary',
    },
  },
  {is: starts('\x89PNG'), kind: picture('PNG')},
  {is: starts('\xff\xd8\xff'), kind: picture('JPEG')},
  {is: starts('GIF8'), kind: picture('GIF')},
  {is: starts('RIFF'), kind: picture('WebP')},
  {is: starts('II*\0', 'MM\0*'), kind: picture('TIFF')},
  {is: starts('BM'), kind: picture('BMP')},
  {is: says(/^%!PS[^]*Adobe Illustrator/), kind: illustrator},
  // the version may follow some bytes of a mail or a web server
  {is: says(/^[^]{0,1000}%PDF-\d/), kind: 'pdf'},
  {
    is: starts('%!'),
    kind: {refusal: 'is PostScript; save it as SVG with Inkscape.', reason: 'postScript'},
  },
  {
    is: starts('PK\x03\x04'),
    kind: {
      refusal:
        "is an archive, as CLO's and Marvelous Designer's projects (.zprj) are; there, use File > Export > DXF (AAMA/ASTM), or unpack it.",
      reason: 'archive',
    },
  },
  {
    is: starts('\x1f\x8b'),
    kind: {refusal: 'is compressed; save it as plain SVG, or unpack it.', reason: 'archive'},
  },
  {is: starts('glTF', 'Kaydara FBX', 'BLENDER', 'PXR-USDC'), kind: model},
  {is: says(/^solid [^]*facet normal/), kind: model},
  {
    is: says(/^\s*(?:IN|SP\d|PU|PD)\d*[;,]/),
    kind: {
      refusal: 'is a file for plotters (HP-GL); export the pattern as DXF (AAMA or ASTM).',
      reason: 'plotter',
    },
  },
  {
    is: says(/^\s*<!doctype html|^\s*<html/i),
    kind: {refusal: 'is a web page; save the pattern itself.', reason: 'webPage'},
  },
  {is: says(/<(?:\w+:)?svg[\s>]/), kind: 'svg'},
  {
    is: says(/<pattern[\s>]/),
    kind: {
      refusal:
        "is a pattern of Valentina or Seamly2D, whose outlines are formulas; there, use File > Export layout as DXF or SVG, or run 'valentina -b NAME -f 25 FILE.val'.",
      reason: 'valentina',
    },
  },
  {
    is: says(/<(?:vit|vst|smis|smms)[\s>]/),
    kind: {
      refusal:
        'holds measurements of Valentina or Seamly2D, and no pattern; export the pattern as DXF or SVG.',
      reason: 'measurements',
    },
  },
  {is: says(/^v[tn]?[ \t]+[-+.\d][^\0]*$|^(?:mtllib|usemtl)\s/m), kind: 'obj'},
];

/** The type of a file; undefined if unknown. */
export function recognised(bytes: Uint8Array): DrawingKind | Refusal | undefined {
  const file = {bytes, text: decoded(bytes.subarray(0, looked))};
  return kinds.find(({is}) => is(file))?.kind;
}
