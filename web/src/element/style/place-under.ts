/** Puts a panel that opens under its button, within the window. */
export function placeUnder(button: Element | null, panel: HTMLElement | null): void {
  if (!panel || !button) return;
  const {right, bottom} = button.getBoundingClientRect();
  const gap = 'var(--sw-space-1)';
  panel.style.position = 'fixed';
  panel.style.inset = `calc(${bottom}px + ${gap}) max(${gap}, ${innerWidth - right}px) auto auto`;
  panel.style.maxWidth = `calc(100vw - 2 * ${gap})`;
}
