/** The command palette, and the keys of its commands. */
import {expect, it} from 'vitest';

import {folded, matching} from '@/app/palette/palette.js';
import type {Command} from '@/commands/editor-command.js';
import {keyOf, shortcutFor, shortcutIds, shortcuts, titleOf} from '@/commands/shortcuts.js';
import {loadTexts, textsOf} from '@/texts/texts.js';
import {languages} from '@/texts/preferences.js';

const command = (title: string, more: Partial<Command> = {}): Command => ({
  ...{id: title, title, run: () => undefined},
  ...more,
});

const found = (commands: readonly Command[], typed: string): readonly string[] =>
  matching(commands, typed).map(({title}) => title);

const list = [
  command('Undo: turn of the print'),
  command('Print: Ogee tulip', {words: 'cm fabric'}),
  command('Turn Waistband by 90°', {words: 'rotate grain'}),
  command('Größe: M', {words: 'size'}),
  command('Symétrie à l’œil'),
  command('Open print', {words: 'load'}),
];

it('shows all commands in their own order until something is typed', () => {
  expect(matching(list, '')).toBe(list);
  expect(matching(list, ' -  ')).toBe(list);
});

it('finds commands in which every typed word occurs, in the name or in what else they are called', () => {
  expect(found(list, 'turn waist')).toEqual(['Turn Waistband by 90°']);
  expect(found(list, 'waist rotate')).toEqual(['Turn Waistband by 90°']);
  expect(found(list, 'waist tulip')).toEqual([]);
  expect(found(list, '90')).toEqual(['Turn Waistband by 90°']);
});

it('finds words whatever their capitals and diacritics', () => {
  expect(found(list, 'GROSSE')).toEqual(['Größe: M']);
  expect(found(list, 'größe')).toEqual(['Größe: M']);
  expect(found(list, 'symetrie oeil')).toEqual(['Symétrie à l’œil']);
  expect(folded('Mayúscula ÅßŒ')).toBe('mayuscula assoe');
});

it('lists first what begins with the word, then what is called so, then what has it inside', () => {
  const prints = [
    command('Fingerprint'),
    command('Cloth', {words: 'print'}),
    command('Choose prints'),
  ];
  expect(found(prints, 'print')).toEqual(['Choose prints', 'Cloth', 'Fingerprint']);
});

it('lists what cannot be done just now after all that can', () => {
  const turns = [command('Turn the selected piece', {why: 'select one'}), command('Return Back')];
  expect(found(turns, 'turn')).toEqual(['Return Back', 'Turn the selected piece']);
});

const pressed = (key: string, held: Partial<KeyboardEvent> = {}) => ({
  ...{key, ctrlKey: false, metaKey: false, altKey: false, shiftKey: false},
  ...held,
});

it('knows a command by its key, with Ctrl or Command, where it works', () => {
  expect(shortcutFor(pressed('k', {ctrlKey: true}), ['page'])).toBe('commands');
  expect(shortcutFor(pressed('K', {metaKey: true}), ['page', 'editor'])).toBe('commands');
  expect(shortcutFor(pressed('k'), ['page', 'editor'])).toBeUndefined();
  expect(shortcutFor(pressed('k'), ['pattern'])).toBe('keep');
  expect(shortcutFor(pressed('K', {shiftKey: true}), ['pattern'])).toBe('keep');
  expect(shortcutFor(pressed('k', {ctrlKey: true, altKey: true}), ['page'])).toBeUndefined();
  expect(shortcutFor(pressed('Z', {ctrlKey: true, shiftKey: true}), ['editor'])).toBe('redo');
  expect(shortcutFor(pressed('z', {ctrlKey: true}), ['editor'])).toBe('undo');
  expect(shortcutFor(pressed('?', {shiftKey: true}), ['editor'])).toBe('keys');
  expect(shortcutFor(pressed('s', {ctrlKey: true}), ['pattern'])).toBeUndefined();
});

it('gives no key to two commands of one place', () => {
  const pairs = shortcutIds.flatMap((id) =>
    shortcuts[id].keys.map((key) => `${shortcuts[id].where === 'pattern' ? 'pattern' : ''} ${key}`),
  );
  expect(new Set(pairs).size).toBe(pairs.length);
});

it.each(languages)('names every command with a key, and its key, in %s', async (language) => {
  await loadTexts(language);
  const texts = textsOf(language);
  const titles = shortcutIds.map((id) => titleOf(id, texts));
  expect(new Set(titles).size).toBe(titles.length);
  expect(titles.filter((title) => title === '')).toEqual([]);
  const {Mod, Shift} = texts.keyNames;
  expect(keyOf('redo', texts)).toBe(`${Mod} ${Shift} Z`);
  expect([keyOf('turn', texts), keyOf('zoomOut', texts)]).toEqual(['R', '−']);
});
