/** Opens the editor's fields for the size of the print. @param from an element inside the editor */
export const wantSize = (from: HTMLElement): void => {
  from.dispatchEvent(new CustomEvent('sw-size-wanted', {bubbles: true, composed: true}));
};
