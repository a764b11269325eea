/** Cutting sheets of Seamwise: the meaning of their lines by the classes of these. [mm] */
import type {XmlElement} from '../base/xml.js';
import {areaOf} from './outlines.js';
import {classesOf} from './styles.js';
import type {Drawn, DrawnText, Sheet} from './walk.js';

const pieceId = /^piece-\d+$/;

/** The group of a piece around a shape or a text. */
const pieceAround = ({groups}: Pick<Drawn | DrawnText, 'groups'>): XmlElement | undefined =>
  groups.find(({attributes}) => pieceId.test(attributes.get('id') ?? ''));

/** The classes of lines that belong to a piece, not to its print. */
const ownClasses = ['cut', 'sew', 'marks'] as const;

const classOf = ({element}: Drawn): (typeof ownClasses)[number] | undefined =>
  ownClasses.find((one) => classesOf(element).includes(one));

const areaIn = ({lines: [line]}: Drawn): number => (line ? areaOf(line) : 0);

/**
 * The sheet with the roles of its lines, without marks of the print, plates and halos; undefined
 * for sheets of other programs.
 */
export function ownSheet(sheet: Sheet): Sheet | undefined {
  const pieces = new Map<XmlElement, Drawn[]>();
  for (const one of sheet.drawn) {
    const piece = pieceAround(one);
    if (piece && classOf(one)) pieces.set(piece, [...(pieces.get(piece) ?? []), one]);
  }
  const groups = [...pieces.values()];
  const isOwn = (some: readonly Drawn[]): boolean => some.some((one) => classOf(one) === 'cut');
  if (groups.length === 0 || !groups.every(isOwn)) return undefined;
  return {
    ...sheet,
    program: 'Seamwise',
    drawn: groups.flatMap(withRoles),
    texts: sheet.texts.filter(pieceAround),
  };
}

function withRoles(lines: readonly Drawn[]): Drawn[] {
  const largest = (name: 'cut' | 'sew'): Drawn | undefined =>
    lines.filter((one) => classOf(one) === name).sort((a, b) => areaIn(b) - areaIn(a))[0];
  const [outline, sewn] = [largest('cut'), largest('sew')];
  return lines.map((one): Drawn => {
    const own = classOf(one) ?? 'marks';
    const cut = one === outline ? 'piece' : 'cut-out';
    const stated = own === 'cut' ? cut : one === sewn ? 'sewn line' : 'mark';
    return {...one, hints: {stated, style: own}};
  });
}
