/** Stops inner events that would leave the element as if they were its own. */
import type {Failure} from '../../model/result/failure.js';
import type {GarmentEvents} from './events.js';
import {drapeEvent, drawnEvent, undrawableEvent} from '../../editor/pattern/scene-drawing.js';

const kept = ['input', 'change', 'select', 'sw-lens-cursor', 'sw-lens-wanted'];

interface InnerListener {
  readonly draped: (news: GarmentEvents['drape']) => void;
  readonly drawn: () => void;
  readonly undrawable: (failure: Failure) => void;
}

/** Keeps these events within a shadow root, and handles those about the drawing. */
export function keepInside(root: EventTarget, {draped, drawn, undrawable}: InnerListener): void {
  for (const type of [...kept, drapeEvent, drawnEvent, undrawableEvent]) {
    root.addEventListener(type, (event) => {
      event.stopPropagation();
    });
  }
  root.addEventListener(drapeEvent, (event) => {
    draped((event as CustomEvent<GarmentEvents['drape']>).detail);
  });
  root.addEventListener(drawnEvent, drawn);
  root.addEventListener(undrawableEvent, (event) => {
    undrawable((event as CustomEvent<Failure>).detail);
  });
}
