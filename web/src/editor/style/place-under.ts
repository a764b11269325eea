/** Puts a panel that opens under its button, within the window. */
export function placeUnder(button: Element | null, panel: HTMLElement | null): void {
  if (!panel || !button) return;
  const {right, bottom} = button.getBoundingClientRect();
  const gap = 'var(--sw-space-1)';
  // a button far to the left leaves the panel no room on its own left; it is no wider than 22rem
  const aside = `min(${innerWidth - right}px, 100vw - 22rem - ${gap})`;
  panel.style.position = 'fixed';
  panel.style.inset = `calc(${bottom}px + ${gap}) max(${gap}, ${aside}) auto auto`;
  panel.style.maxWidth = `calc(100vw - 2 * ${gap})`;
}
