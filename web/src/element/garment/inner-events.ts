/** Events of the parts that would leave the element as if they were its own. */
import type {Failure} from '../../model/failure.js';
import {drawnEvent, undrawableEvent} from '../../editor/pattern/drawing.js';

const kept = ['input', 'change', 'select', 'sw-lens-cursor', 'sw-lens-wanted'];

interface InnerListener {
  readonly drawn: () => void;
  readonly undrawable: (failure: Failure) => void;
}

/** Keeps them within a shadow, and hears those that are about the drawing. */
export function keepInside(root: EventTarget, {drawn, undrawable}: InnerListener): void {
  for (const type of [...kept, drawnEvent, undrawableEvent]) {
    root.addEventListener(type, (event) => {
      event.stopPropagation();
    });
  }
  root.addEventListener(drawnEvent, drawn);
  root.addEventListener(undrawableEvent, (event) => {
    undrawable((event as CustomEvent<Failure>).detail);
  });
}
