/** Keys of the sewing tool, while the pattern has the focus. */
import {undoAndSay} from '../history/step-words.js';
import type {Workbench} from '../workbench.js';
import type {SeamChooser} from './seam-chooser.js';

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
  m: send({type: 'join'}),
};

const ways: Readonly<Record<string, readonly [by: 1 | -1, within: 'piece' | 'pieces']>> = {
  ArrowLeft: [-1, 'piece'],
  ArrowRight: [1, 'piece'],
  ArrowUp: [-1, 'pieces'],
  ArrowDown: [1, 'pieces'],
};

/** @returns true if the key has an effect */
export function seamKey(chooser: SeamChooser, workbench: Workbench, event: KeyboardEvent): boolean {
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
