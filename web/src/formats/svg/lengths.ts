/** Determines the length of an SVG unit. */
import type {UnitGuess} from '../../model/garment/imported-drawing.js';
import {FileError} from '../../model/base/versioned-file.js';
import type {XmlDocument} from '../base/xml.js';
import {numbersOf} from './matrix.js';

/** Millimetres per absolute unit. */
const paperUnits: Readonly<Record<string, number>> = {
  ...{mm: 1, cm: 10, m: 1000, in: 25.4, pt: 25.4 / 72, pc: 25.4 / 6, q: 0.25},
};

interface SvgProgram {
  /** Name and version, if the file states them. */
  readonly name?: string;
  /** Pixels per inch; usually 96, as in the standard. */
  readonly perInch: number;
}

/**
 * Name of two programs that Qt makes indistinguishable. Their text is ordered: letter and name of
 * the piece, then of the pattern.
 */
export const valentina = 'Valentina or Seamly';

/** The program that wrote a file, from its traces in the file. */
export function programOf({root, comments}: XmlDocument): SvgProgram {
  const {attributes} = root;
  const said = comments.join(' ');
  const freesewing = attributes.get('freesewing');
  if (freesewing !== undefined) return {name: `FreeSewing ${freesewing}`, perInch: 96};
  const inkscape = attributes.get('inkscape:version');
  if (inkscape !== undefined || said.includes('Created with Inkscape')) {
    const [, major, minor] = /^(\d+)\.(\d+)/.exec(inkscape ?? '') ?? [];
    const isOld = Number(major) === 0 && Number(minor) < 92;
    return {
      name: `Inkscape ${(inkscape ?? '').split(' ')[0] ?? ''}`.trim(),
      perInch: isOld ? 90 : 96,
    };
  }
  const isIllustrator = said.includes('Adobe Illustrator') || attributes.has('data-name');
  if (isIllustrator) {
    const version = /Adobe Illustrator (\d[\d.]*)/.exec(said)?.[1];
    return {name: `Adobe Illustrator ${version ?? ''}`.trim(), perInch: 72};
  }
  if (attributes.get('baseProfile') === 'tiny' && /^(?:Pattern)?$/.test(titlesOf(root)[0] ?? '')) {
    return {name: valentina, perInch: 96};
  }
  const named = /(Valentina|Seamly\w*|CorelDRAW|Affinity|LibreCAD|Blender)[^,;\n]*/i.exec(
    [...titlesOf(root), said].join('\n'),
  )?.[0];
  return {...(named !== undefined && {name: named.trim()}), perInch: 96};
}

const titlesOf = (root: XmlDocument['root']): string[] =>
  root.children.flatMap((child) =>
    typeof child !== 'string' && (child.name === 'title' || child.name === 'desc')
      ? child.children.filter((one) => typeof one === 'string')
      : [],
  );

interface SvgScale {
  /** Millimetres per user unit of the root; undefined if the file does not define it. */
  readonly millimetres?: number;
  readonly because: UnitGuess['because'];
  /** True if width or height are absolute lengths. */
  readonly isStated: boolean;
  /** The assumption made. */
  readonly note?: string;
}

/**
 * The scale from the outermost element. Percentages count as missing.
 * @throws {FileError} for a size of 0
 */
export function scaleOf({root, comments}: XmlDocument, file: string): SvgScale {
  const {perInch, name} = programOf({root, comments});
  const [, , across, down] = numbersOf(root.attributes.get('viewBox'));
  const pixel = 25.4 / perInch;
  const sides = [
    {stated: root.attributes.get('width'), units: across},
    {stated: root.attributes.get('height'), units: down},
  ];
  const scales = sides.flatMap(({stated, units}) => {
    const [, number, unit = ''] =
      /^\s*\+?([\d.]+(?:e[-+]?\d+)?)\s*([a-z%]*)\s*$/i.exec(stated ?? '') ?? [];
    const paper = paperUnits[unit.toLowerCase()];
    const isPixels = unit === '' || unit.toLowerCase() === 'px';
    const length = Number(number) * (paper ?? (isPixels ? pixel : NaN));
    if (length === 0) {
      throw new FileError(
        file,
        `states a size of '${stated ?? ''}'; correct its width and height.`,
      );
    }
    if (!(length > 0)) return [];
    // without a view box a unit is a pixel, regardless of the size
    const scale = units !== undefined && units > 0 ? length / units : pixel;
    return [{scale, isStated: paper !== undefined}];
  });
  const isStated = scales.some((one) => one.isStated);
  const found = scales.filter((one) => one.isStated === isStated).map((one) => one.scale);
  if (isStated) return {millimetres: Math.min(...found), because: 'stated', isStated};
  // Illustrator omits the size of files for web pages, and writes points
  const isKnown = name?.startsWith('Adobe Illustrator') ?? false;
  if (found.length === 0 && !isKnown) {
    return {
      because: 'size',
      isStated,
      note: 'The file does not say how large it is; that was guessed from its pieces.',
    };
  }
  const note = `Its size is in pixels, of which ${name ?? 'most programs'} ${name === undefined ? 'have' : 'has'} ${perInch} in an inch.`;
  return {
    millimetres: found.length > 0 ? Math.min(...found) : pixel,
    because: 'program',
    isStated,
    note,
  };
}
