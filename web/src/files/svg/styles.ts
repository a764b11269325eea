/** The SVG styles that determine the drawing of a line. */
import type {XmlElement} from '../base/xml.js';
import {userUnits} from './values.js';

/** The style of an element, including inherited properties. */
export interface Style {
  readonly stroke: string;
  readonly fill: string;
  readonly isHidden: boolean;
  readonly isDashed: boolean;
  /** From 0 to 1, including that of the groups around. */
  readonly opacity: number;
  /** True if a path is filled by the even-odd rule. */
  readonly isEvenOdd: boolean;
  /** Size in user units of the text's surroundings. */
  readonly fontSize: number;
}

export const initialStyle: Style = {
  ...{stroke: 'none', fill: 'black', isHidden: false, fontSize: 16},
  ...{isDashed: false, opacity: 1, isEvenOdd: false},
};

type Properties = Readonly<Record<string, string>>;

/** Properties by class name. Other selectors are ignored, since pattern programs write classes. */
export type StyleSheet = ReadonlyMap<string, Properties>;

/** The declarations of a `style` attribute or rule, in lower case. */
export function propertiesOf(declarations: string): Properties {
  const pairs = declarations.split(';').flatMap((one) => {
    const colon = one.indexOf(':');
    if (colon < 0) return [];
    const value = one.slice(colon + 1).replace('!important', '');
    return [[one.slice(0, colon).trim().toLowerCase(), value.trim().toLowerCase()] as const];
  });
  return Object.fromEntries(pairs);
}

/** The class rules of `style` elements. */
export function sheetOf(texts: readonly string[]): StyleSheet {
  const sheet = new Map<string, Properties>();
  for (const text of texts) {
    const bare = text.replaceAll(/\/\*[^]*?\*\//g, '');
    for (const [, selectors = '', body = ''] of bare.matchAll(/([^{}]+)\{([^{}]*)\}/g)) {
      for (const selector of selectors.split(',')) {
        const name = /^\s*(?:[a-z]+)?\.([\w-]+)\s*$/i.exec(selector)?.[1];
        if (name !== undefined) sheet.set(name, {...sheet.get(name), ...propertiesOf(body)});
      }
    }
  }
  return sheet;
}

export const classesOf = ({attributes}: XmlElement): string[] =>
  (attributes.get('class') ?? '').split(/\s+/).filter((name) => name !== '');

function fontSizeOf(value: string | undefined, around: number): number {
  const [, number, unit = ''] = /^([\d.]+)\s*([a-z%]*)$/.exec(value ?? '') ?? [];
  const size = Number(number) * (unit === 'em' ? around : userUnits(unit));
  return size > 0 && unit !== '%' ? size : around;
}

/** A paint; 'none' if it is transparent or has no width. */
const paintOf = (paint: string, opacity: string | undefined, width?: string): string =>
  paint === 'transparent' || shareOf(opacity) === 0 || /^0(?:\.0*)?[a-z]*$/.test(width ?? '')
    ? 'none'
    : paint;

/** A share from 0 to 1; 1 if it is missing or invalid. */
function shareOf(value: string | undefined): number {
  const [, number = '1', percent] = /^([\d.]+)(%?)$/.exec(value ?? '') ?? [];
  const share = Number(number) / (percent === '%' ? 100 : 1);
  return Number.isFinite(share) ? Math.min(1, share) : 1;
}

/** Returns whether a list of dashes has gaps. */
const isDashes = (list: string): boolean =>
  (list.match(/[\d.]+/g) ?? []).some((one) => Number(one) > 0);

/** The style of an element in a group with style `around`; undefined if it is not drawn. */
export function styleOf(element: XmlElement, around: Style, sheet: StyleSheet): Style | undefined {
  const {attributes} = element;
  const own = propertiesOf(attributes.get('style') ?? '');
  const ruled = Object.assign(
    {},
    ...classesOf(element).map((name) => sheet.get(name)),
  ) as Properties;
  const value = (name: string): string | undefined =>
    [own[name], ruled[name], attributes.get(name)?.trim().toLowerCase()].find(
      (one) => one !== undefined && one !== 'inherit',
    );
  if (value('display') === 'none' || value('opacity') === '0') return undefined;
  const visibility = value('visibility');
  const dashes = value('stroke-dasharray');
  const rule = value('fill-rule');
  const opacity = around.opacity * shareOf(value('opacity'));
  return {
    stroke: paintOf(
      value('stroke') ?? around.stroke,
      value('stroke-opacity'),
      value('stroke-width'),
    ),
    fill: paintOf(value('fill') ?? around.fill, value('fill-opacity')),
    isDashed: dashes === undefined ? around.isDashed : isDashes(dashes),
    isEvenOdd: rule === undefined ? around.isEvenOdd : rule === 'evenodd',
    opacity,
    isHidden: visibility === undefined ? around.isHidden : visibility !== 'visible',
    fontSize: fontSizeOf(value('font-size'), around.fontSize),
  };
}
