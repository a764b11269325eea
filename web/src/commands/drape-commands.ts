/** Commands of the drape, by key or by name. */
import {fabricOf} from '../model/design/design.js';
import {fabricNames} from '../model/result/draped-garment.js';
import type {DrapeTexts} from '../texts/drape-texts.js';
import type {Texts} from '../texts/texts.js';
import {presetNames} from '../viewer/drape/camera.js';
import type {DrapeView} from '../viewer/drape/drape-view.js';
import type {Workbench} from '../workbench/workbench.js';
import type {Command} from './editor-command.js';

/** State and functions that keys and commands of the drape use. */
interface CommandedGarment {
  readonly workbench: Workbench;
  readonly view: DrapeView | undefined;
  readonly beforeAfter: {toggle: () => void};
  toggleForm(): void;
  toggleSeams(): void;
}

/** Zoom step of a key. */
const notch = 1.25;

/** Commands of the camera; a drape for display only has them, too. */
function looking({view}: CommandedGarment, texts: Texts, words: DrapeTexts): readonly Command[] {
  const {commands, lists, pattern} = texts;
  const also = {show: commands.also.view, zoom: commands.also.zoom};
  const isQuiet = matchMedia('(prefers-reduced-motion: reduce)').matches;
  return [
    ...presetNames.map((name, k): Command => ({
      ...{id: `look ${name}`, title: lists.of(words.look, words.looks[name]), key: String(k + 1)},
      words: also.show,
      run: () => {
        view?.camera.look(name);
      },
    })),
    ...(isQuiet
      ? []
      : [
          {
            ...{id: 'turntable', title: words.turntable, key: 'T', words: also.show},
            run: () => {
              view?.camera.setTurntable(!view.camera.isTurning);
            },
          },
        ]),
    {
      ...{id: 'fit worn', title: pattern.fit, key: '0', words: also.zoom},
      run: () => {
        view?.camera.look();
      },
    },
    {
      ...{id: 'zoom worn in', title: pattern.zoomIn, key: '+', words: also.zoom},
      run: () => {
        view?.camera.zoomBy(notch);
      },
    },
    {
      ...{id: 'zoom worn out', title: pattern.zoomOut, key: '−', words: also.zoom},
      run: () => {
        view?.camera.zoomBy(1 / notch);
      },
    },
  ];
}

/** Commands that walk from piece to piece; the camera faces each piece. */
function walking({workbench}: CommandedGarment, words: DrapeTexts): readonly Command[] {
  const walk = (step: 1 | -1): void => {
    const {selected} = workbench.selection;
    const {scenes} = workbench.sheet;
    const count = scenes?.now.pieces.length ?? 0;
    const first = step > 0 ? -1 : 0;
    const from = selected?.kind === 'piece' ? selected.piece : first;
    if (count > 0)
      workbench.selection.select({kind: 'piece', piece: (from + step + count) % count});
  };
  return [
    {
      ...{id: 'next piece', title: words.nextPiece, key: 'N'},
      run: () => {
        walk(1);
      },
    },
    {
      ...{id: 'piece before', title: words.pieceBefore, key: 'P'},
      run: () => {
        walk(-1);
      },
    },
  ];
}

/** Commands for the display of the drape, and for its fabric. */
function showing(garment: CommandedGarment, texts: Texts, words: DrapeTexts): readonly Command[] {
  const {workbench} = garment;
  const {commands, lists, pattern} = texts;
  const {view: also, print: cloth} = commands.also;
  const {design} = workbench.history;
  return [
    {
      ...{id: 'form', title: words.form, key: 'D', words: also},
      run: () => {
        garment.toggleForm();
      },
    },
    {
      ...{id: 'worn seams', title: words.seams, key: 'S', words: also},
      run: () => {
        garment.toggleSeams();
      },
    },
    {
      ...{id: 'worn wipe', title: pattern.wipe, key: 'B', words: also},
      run: () => {
        garment.beforeAfter.toggle();
      },
    },
    ...fabricNames
      .filter((name) => design && name !== fabricOf(design))
      .map((fabric): Command => ({
        ...{id: `fabric ${fabric}`, title: lists.of(words.fabric, words.fabrics[fabric])},
        words: cloth,
        run: () => {
          workbench.history.change({fabric});
        },
      })),
  ];
}

/** @param edits true if the user can change the garment */
export const drapeCommands = (
  garment: CommandedGarment,
  edits: boolean,
  texts: Texts,
  words: DrapeTexts,
): readonly Command[] => [
  ...looking(garment, texts, words),
  ...(edits ? [...walking(garment, words), ...showing(garment, texts, words)] : []),
];
