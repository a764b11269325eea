/** Asks the editor for the fields in which the size of the print is entered. @param from what stands in it */
export const wantSize = (from: HTMLElement): void => {
  from.dispatchEvent(new CustomEvent('sw-size-wanted', {bubbles: true, composed: true}));
};
