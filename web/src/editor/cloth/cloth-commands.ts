/** What can be done to the pieces on their cloth, by a key or by its name. */
import type {ClothTexts} from '../../texts/cloth-texts.js';
import type {Texts} from '../../texts/texts.js';
import type {Command} from '../commands/command.js';

/** The cloth as keys and commands see it. */
interface CommandedCloth {
  /** Something is laid, of the present design. */
  readonly isReady: boolean;
  zoomBy(factor: number): void;
  fit(): void;
  walk(step: 1 | -1): void;
  turn(): void;
  togglePin(): void;
  takeOff(): void;
  pack(): void;
  toggleFlawTool(): void;
}

/** One notch of zoom by a key. */
const notch = 1.25;

export function clothCommands(
  cloth: CommandedCloth,
  {commands, pattern}: Texts,
  words: ClothTexts,
): readonly Command[] {
  const {view, zoom} = commands.also;
  const looks: readonly Command[] = [
    {
      ...{id: 'fit cloth', title: pattern.fit, key: '0', words: zoom},
      run: () => {
        cloth.fit();
      },
    },
    {
      ...{id: 'zoom cloth in', title: pattern.zoomIn, key: '+', words: zoom},
      run: () => {
        cloth.zoomBy(notch);
      },
    },
    {
      ...{id: 'zoom cloth out', title: pattern.zoomOut, key: '−', words: zoom},
      run: () => {
        cloth.zoomBy(1 / notch);
      },
    },
  ];
  if (!cloth.isReady) return looks;
  return [
    ...looks,
    {
      ...{id: 'next laid piece', title: words.nextPiece, key: 'N', words: view},
      run: () => {
        cloth.walk(1);
      },
    },
    {
      ...{id: 'laid piece before', title: words.pieceBefore, key: 'Shift N', words: view},
      run: () => {
        cloth.walk(-1);
      },
    },
    {
      ...{id: 'turn laid piece', title: words.turn, key: 'R', words: commands.also.turn},
      run: () => {
        cloth.turn();
      },
    },
    {
      ...{id: 'pin laid piece', title: words.pin, key: 'P', words: commands.also.keep},
      run: () => {
        cloth.togglePin();
      },
    },
    {
      ...{id: 'take laid piece off', title: words.takeOff, key: 'Delete'},
      run: () => {
        cloth.takeOff();
      },
    },
    {
      ...{id: 'pack', title: words.packRest, key: 'A'},
      run: () => {
        cloth.pack();
      },
    },
    {
      ...{id: 'flaw', title: words.flaw, key: 'X'},
      run: () => {
        cloth.toggleFlawTool();
      },
    },
  ];
}
