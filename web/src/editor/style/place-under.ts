/** Places an open panel under its button, within the window. */
export function placeUnder(button: Element | null, panel: HTMLElement | null): void {
  if (!panel || !button) return;
  const {right, bottom} = button.getBoundingClientRect();
  const gap = 'var(--sw-space-1)';
  // no room for the panel remains left of a button far to the left; its width is at most 22rem
  const aside = `min(${innerWidth - right}px, 100vw - 22rem - ${gap})`;
  panel.style.position = 'fixed';
  panel.style.inset = `calc(${bottom}px + ${gap}) max(${gap}, ${aside}) auto auto`;
  panel.style.maxWidth = `calc(100vw - 2 * ${gap})`;
}
