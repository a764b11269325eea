/** Determines the length of an SVG unit. */
import type {UnitGuess} from '../../model/garment/imported-drawing.js';
import {FileError} from '../../model/base/versioned-file.js';
import type {XmlDocument} from '../base/xml.js';
import {paperOf} from '../base/frames.js';
import {densities, paperUnits} from '../base/units.js';
import {fitOf, numbersOf} from './values.js';

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

/** The pixels per inch at which a page has the size of a sheet of paper; undefined if none has. */
const densityOf = (page: readonly [number, number]): number | undefined =>
  densities.find((density) => {
    const [across, down] = page.map((side) => (25.4 * side) / density);
    // sides are rounded to whole pixels, and ISO sizes to whole millimetres
    return paperOf([across ?? 0, down ?? 0], Math.max(0.6, (25.4 / density) * 0.6));
  });

interface SvgScale {
  /** Millimetres per user unit of the root; undefined if the file does not define it. */
  readonly millimetres?: number;
  /** Height of a user unit as a share of its width, if the view box is stretched. Default 1. */
  readonly stretch?: number;
  readonly because: UnitGuess['because'];
  /** True if width or height are absolute lengths. */
  readonly isStated: boolean;
  /** The assumption made. */
  readonly note?: string;
}

/**
 * The scale from the outermost element. Percentages count as missing.
 * @param pixelsPerInch makes the file's lengths on paper count as missing, too
 * @throws {FileError} for a size of 0
 */
export function scaleOf(
  {root, comments}: XmlDocument,
  file: string,
  pixelsPerInch?: number,
): SvgScale {
  const {perInch: usual, name} = programOf({root, comments});
  const perInch = pixelsPerInch ?? usual;
  const [, , across, tall] = numbersOf(root.attributes.get('viewBox'));
  const pixel = 25.4 / perInch;
  const sides = [
    {stated: root.attributes.get('width'), units: across},
    {stated: root.attributes.get('height'), units: tall},
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
  const isStated = pixelsPerInch === undefined && scales.some((one) => one.isStated);
  const found = scales.filter((one) => one.isStated === isStated).map((one) => one.scale);
  const [width = pixel, height = width] = found;
  const [millimetres, down] = fitOf(root.attributes.get('preserveAspectRatio'), width, height);
  const stretch = down / millimetres;
  if (isStated || pixelsPerInch !== undefined) {
    return {millimetres, stretch, because: 'stated', isStated};
  }
  // Illustrator omits the size of files for web pages, and writes points
  const isKnown = name?.startsWith('Adobe Illustrator') ?? false;
  if (found.length === 0 && !isKnown) {
    const density = densityOf([across ?? 0, tall ?? 0]);
    if (density !== undefined) {
      return {
        millimetres: 25.4 / density,
        because: 'measured',
        isStated,
        note: `Its size is in pixels, of which a sheet of paper with its view box has ${density} in an inch.`,
      };
    }
    return {
      because: 'size',
      isStated,
      note: 'The file does not say how large it is; that was guessed from its pieces.',
    };
  }
  const note = `Its size is in pixels, of which ${name ?? 'most programs'} ${name === undefined ? 'have' : 'has'} ${perInch} in an inch.`;
  return {
    ...{millimetres, stretch},
    because: 'program',
    isStated,
    note,
  };
}
