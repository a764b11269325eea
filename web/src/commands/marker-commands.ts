/** Commands of the fabric layout, by key or by name. */
import type {MarkerTexts} from '../texts/marker-texts.js';
import type {Texts} from '../texts/texts.js';
import {keysOf, type KeyList, type Command} from './editor-command.js';

/** State and functions that commands and keys of the fabric layout use. */
interface CommandedMarker {
  /** True if there is a marker of the present design. */
  readonly isReady: boolean;
  zoomBy(factor: number): void;
  fit(): void;
  walk(step: 1 | -1): void;
  turn(): void;
  togglePin(): void;
  takeOff(): void;
  pack(): void;
  toggleFlawTool(): void;
  /** Adds a flaw in the visible part, to be moved by keys. */
  putFlaw(): void;
}

/** Zoom step of a key. */
const notch = 1.25;

function looking(fabric: CommandedMarker, {commands, pattern}: Texts): readonly Command[] {
  const {zoom} = commands.also;
  return [
    {
      ...{id: 'fit fabric', title: pattern.fit, key: '0', words: zoom},
      run: () => {
        fabric.fit();
      },
    },
    {
      ...{id: 'zoom fabric in', title: pattern.zoomIn, key: '+', words: zoom},
      run: () => {
        fabric.zoomBy(notch);
      },
    },
    {
      ...{id: 'zoom fabric out', title: pattern.zoomOut, key: '−', words: zoom},
      run: () => {
        fabric.zoomBy(1 / notch);
      },
    },
  ];
}

function handling(
  fabric: CommandedMarker,
  {commands}: Texts,
  words: MarkerTexts,
): readonly Command[] {
  const {view} = commands.also;
  return [
    {
      ...{id: 'next laid piece', title: words.nextPiece, key: 'N', words: view},
      run: () => {
        fabric.walk(1);
      },
    },
    {
      ...{id: 'laid piece before', title: words.pieceBefore, key: 'Shift N', words: view},
      run: () => {
        fabric.walk(-1);
      },
    },
    {
      ...{id: 'turn laid piece', title: words.turn, key: 'R', words: commands.also.turn},
      run: () => {
        fabric.turn();
      },
    },
    {
      ...{id: 'pin laid piece', title: words.pin, key: 'P', words: commands.also.keep},
      run: () => {
        fabric.togglePin();
      },
    },
    {
      ...{id: 'take laid piece off', title: words.takeOff, key: 'Delete'},
      run: () => {
        fabric.takeOff();
      },
    },
    {
      ...{id: 'pack', title: words.packRest, key: 'A'},
      run: () => {
        fabric.pack();
      },
    },
    {
      ...{id: 'flaw', title: words.flaw, key: 'X'},
      run: () => {
        fabric.toggleFlawTool();
      },
    },
    {
      ...{id: 'add flaw', title: words.addFlaw, key: 'Shift X'},
      run: () => {
        fabric.putFlaw();
      },
    },
  ];
}

export const markerCommands = (
  fabric: CommandedMarker,
  texts: Texts,
  words: MarkerTexts,
): readonly Command[] => [
  ...looking(fabric, texts),
  ...(fabric.isReady ? handling(fabric, texts, words) : []),
];

/** All keys of the view, including those without use at present. */
export function markerKeys(fabric: CommandedMarker, texts: Texts, words: MarkerTexts): KeyList {
  const {move, moveOnto, turnOnto, leave, closeFlaw, sizeFlaw} = words.keys;
  const arrows = '←  →  ↑  ↓';
  const {Shift} = texts.keyNames;
  const shown = (key: string): string =>
    key.replace('Shift', Shift).replace('Delete', words.deleteKey);
  const commands = keysOf([...handling(fabric, texts, words), ...looking(fabric, texts)]);
  return [
    [arrows, move],
    [`Alt ${arrows}`, moveOnto],
    ...commands.map(([key, meaning]) => [shown(key), meaning] as const),
    ['Alt R', turnOnto],
    [`${Shift} ${arrows}`, sizeFlaw],
    ['Enter', closeFlaw],
    ['Esc', leave],
  ];
}
