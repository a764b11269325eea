/** The sewing tool with its texts and keys; loaded on demand. */
import type {Overlay} from '../../scene/overlay.js';
import type {PatternScene} from '../../scene/scene.js';
import type {Format} from '../../texts/format.js';
import {loadSewTexts} from '../../texts/sew-texts.js';
import type {Texts} from '../../texts/texts.js';
import type {EditingTool, Pointed} from '../later-tool.js';
import type {Workbench} from '../workbench.js';
import {SeamChooser} from './seam-chooser.js';
import {undoAndSay} from '../history/step-change.js';

export class SewingTool implements EditingTool {
  readonly chooser: SeamChooser;
  readonly #workbench: Workbench;

  constructor(workbench: Workbench, chooser: SeamChooser) {
    this.#workbench = workbench;
    this.chooser = chooser;
  }

  get keys() {
    return this.chooser.sew.keys;
  }

  title({sewing}: Texts): string {
    return sewing.tool;
  }

  hover(at: Pointed | undefined): void {
    this.chooser.hover(at?.target);
  }

  take({target}: Pointed, isMore: boolean): void {
    this.chooser.take(target, isMore);
  }

  back(): boolean {
    return this.chooser.send({type: 'back'});
  }

  words(texts: Texts, format: Format): string {
    return this.chooser.words(texts, format);
  }

  marks(scene: PatternScene): Overlay {
    return this.chooser.marks(scene);
  }

  press(event: KeyboardEvent): boolean {
    return seamKey(this.chooser, this.#workbench, event);
  }

  /** Id of the chosen edge, for `aria-activedescendant`. */
  get activeId(): string | undefined {
    const {run, other} = this.chooser.state;
    const active = other[0] ?? run[0];
    return active && `edge-${active.piece}-${active.edge}`;
  }
}

/** Loads the texts and makes the tool. @throws {Error} if there is no network */
export async function sewingTool(workbench: Workbench, changed: () => void): Promise<SewingTool> {
  const {language, messages} = workbench.preferences.chosen;
  const texts = await loadSewTexts(language, messages);
  return new SewingTool(workbench, new SeamChooser(workbench, texts, changed));
}

/** Keys of the sewing tool, while the pattern has the focus. */
type Act = (chooser: SeamChooser) => void;

const send =
  (event: Parameters<SeamChooser['send']>[0]): Act =>
  (chooser) => {
    chooser.send(event);
  };

const acts: Readonly<Record<string, Act>> = {
  ' ': send({type: 'hold'}),
  Enter: send({type: 'hold'}),
  Delete: send({type: 'unsew'}),
  Backspace: send({type: 'unsew'}),
  r: send({type: 'turn'}),
  h: send({type: 'open'}),
  q: send({type: 'suggest'}),
  n: send({type: 'next'}),
  p: (chooser) => {
    chooser.split();
  },
};

/** Keys while a question is open. */
const answers: Readonly<Record<string, Act>> = {
  y: send({type: 'yes'}),
  n: send({type: 'no'}),
  s: send({type: 'skip'}),
  l: send({type: 'skip'}),
  b: (chooser) => {
    chooser.unanswer();
  },
  m: send({type: 'join'}),
};

const ways: Readonly<Record<string, readonly [by: 1 | -1, within: 'piece' | 'pieces']>> = {
  ArrowLeft: [-1, 'piece'],
  ArrowRight: [1, 'piece'],
  ArrowUp: [-1, 'pieces'],
  ArrowDown: [1, 'pieces'],
};

/** @returns true if the key has an effect */
function seamKey(chooser: SeamChooser, workbench: Workbench, event: KeyboardEvent): boolean {
  const {shiftKey} = event;
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  if (key === 'Tab') return chooser.walk(shiftKey ? -1 : 1, 'all');
  if (key === 'u') {
    undoAndSay(workbench);
    return true;
  }
  const [by, within] = ways[key] ?? [];
  if (by && within) {
    if (shiftKey && within === 'piece') chooser.send({type: 'stretch', by});
    else chooser.walk(by, within);
    return true;
  }
  if (/^[1-5]$/.test(key)) {
    chooser.send({type: 'sewTo', candidate: Number(key)});
    return true;
  }
  if (key === 'a' && chooser.state.suggests) {
    chooser.send({type: 'acceptAll'});
    return true;
  }
  const act = (chooser.question && answers[key]) ?? acts[key];
  act?.(chooser);
  return act !== undefined;
}
