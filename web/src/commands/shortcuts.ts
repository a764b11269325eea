/** Keyboard shortcuts of all commands, for handling keys, displaying them and listing commands. */
import type {Texts} from '../texts/texts.js';

/**
 * Scope of a shortcut. `page`: everywhere, also in text fields; `editor`: everywhere outside text
 * fields; `pattern`: while the pattern has the focus.
 */
type Where = 'page' | 'editor' | 'pattern';

interface Shortcut {
  readonly where: Where;
  /** The first key is displayed. `Mod` is Ctrl or Command. */
  readonly keys: readonly string[];
}

const table = {
  commands: {where: 'page', keys: ['Mod K']},
  keys: {where: 'editor', keys: ['?']},
  undo: {where: 'editor', keys: ['Mod Z']},
  redo: {where: 'editor', keys: ['Mod Shift Z', 'Mod Y']},
  views: {where: 'editor', keys: ['V']},
  save: {where: 'page', keys: ['Mod S']},
  cut: {where: 'page', keys: ['Mod Shift S']},
  open: {where: 'page', keys: ['Mod O']},
  sew: {where: 'pattern', keys: ['J']},
  fold: {where: 'pattern', keys: ['D']},
  piece: {where: 'pattern', keys: ['S']},
  axis: {where: 'pattern', keys: ['X']},
  pair: {where: 'pattern', keys: ['P']},
  move: {where: 'pattern', keys: ['M']},
  keep: {where: 'pattern', keys: ['K']},
  grain: {where: 'pattern', keys: ['G']},
  turn: {where: 'pattern', keys: ['R']},
  lens: {where: 'pattern', keys: ['L']},
  clothOnly: {where: 'pattern', keys: ['C']},
  fit: {where: 'pattern', keys: ['F', '0']},
  zoomIn: {where: 'pattern', keys: ['+', '=']},
  zoomOut: {where: 'pattern', keys: ['-']},
  zoom: {where: 'pattern', keys: ['Z']},
} as const satisfies Readonly<Record<string, Shortcut>>;

export type ShortcutId = keyof typeof table;

/** Shortcuts of a scope. */
export type ShortcutIn<Place extends Where> = {
  [Id in ShortcutId]: (typeof table)[Id]['where'] extends Place ? Id : never;
}[ShortcutId];

export const shortcuts: Readonly<Record<ShortcutId, Shortcut>> = table;

export const shortcutIds = Object.keys(table) as readonly ShortcutId[];

type Pressed = Pick<KeyboardEvent, 'key' | 'ctrlKey' | 'metaKey' | 'altKey' | 'shiftKey'>;

/**
 * Key name such as "Mod Shift Z" or "S". Shift does not change the name of a letter without Ctrl.
 */
function nameOf({key, ctrlKey, metaKey, shiftKey}: Pressed): string {
  const name = key.length === 1 ? key.toUpperCase() : key;
  if (!ctrlKey && !metaKey) return name;
  return shiftKey ? `Mod Shift ${name}` : `Mod ${name}`;
}

/** Returns the command of a key event in these scopes, if any. */
export function shortcutFor<Place extends Where>(
  event: Pressed,
  places: readonly Place[],
): ShortcutIn<Place> | undefined {
  if (event.altKey) return undefined;
  const name = nameOf(event);
  const found = shortcutIds.find((id) => {
    const {where, keys} = shortcuts[id];
    return (places as readonly Where[]).includes(where) && keys.includes(name);
  });
  return found as ShortcutIn<Place> | undefined;
}

const isApple = (): boolean =>
  'navigator' in globalThis && /Mac OS X|iPhone|iPad/.test(navigator.userAgent);

/** Returns a command's key as printed on the keyboard: "Ctrl Shift Z". */
export function keyOf(id: ShortcutId, {keyNames}: Pick<Texts, 'keyNames'>): string {
  const names = isApple() ? {Mod: '⌘', Shift: '⇧'} : keyNames;
  const [key = ''] = shortcuts[id].keys;
  return key.replace('Mod', names.Mod).replace('Shift', names.Shift).replace(/^-$/, '−');
}

/** Returns a command's name in the user's language. */
export function titleOf(id: ShortcutId, texts: Texts): string {
  const {app, sewing, folding, symmetry, keep, pattern, commands, lists} = texts;
  const {views} = pattern;
  const titles: Readonly<Record<ShortcutId, string>> = {
    ...{commands: commands.title, keys: app.keys, undo: app.undo, redo: app.redo},
    views: lists.of(
      views.label,
      `${views.pattern}, ${views.garment}, ${views.both}, ${views.marker}`,
    ),
    ...{save: app.saveProject, cut: app.cut, open: app.openGarment},
    ...{
      sew: sewing.tool,
      fold: folding.tool,
      piece: symmetry.piece,
      axis: commands.axis,
      pair: symmetry.pair,
      move: symmetry.move,
    },
    ...{keep: keep.tool, grain: commands.grain, turn: commands.turnSelected, lens: commands.lens},
    ...{clothOnly: pattern.clothOnly, fit: pattern.fit},
    ...{zoomIn: pattern.zoomIn, zoomOut: pattern.zoomOut, zoom: pattern.zoomPercent},
  };
  return titles[id];
}
