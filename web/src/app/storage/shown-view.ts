/** The view of the last visit. */
import {editorViews, type EditorView} from '../../editor/editor.js';

const key = 'seamwise.view';

/** Width of the window below which there is no room for two views. [CSS px] */
const narrow = 640;

/** Returns the stored view, or the usual one. */
export function storedView(): EditorView {
  const usual = innerWidth < narrow ? 'garment' : 'both';
  try {
    const stored = localStorage.getItem(key);
    return editorViews.find((view) => view === stored) ?? usual;
  } catch {
    return usual; // no storage here
  }
}

export function keepView(view: EditorView): void {
  try {
    localStorage.setItem(key, view);
  } catch {
    // the next visit begins with the usual view
  }
}
