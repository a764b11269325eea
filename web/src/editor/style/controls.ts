/** Styles of buttons, fields and headings in all parts. */
import {css} from 'lit';

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

export const controls = css`
  *,
  *::before,
  *::after {
    box-sizing: border-box;
  }
  h2,
  h3 {
    margin: 0;
    font-size: var(--sw-text);
    font-weight: 600;
  }
  p {
    margin: 0;
  }
  button,
  input,
  select {
    font: inherit;
    color: inherit;
  }
  button {
    display: inline-flex;
    align-items: center;
    justify-content: center;
    gap: var(--sw-space-1);
    min-height: var(--sw-target);
    padding: 0 var(--sw-space-3);
    border: 1px solid transparent;
    border-radius: var(--sw-radius);
    background: transparent;
    white-space: nowrap;
    cursor: pointer;
  }
  button:hover:not(:disabled) {
    background: color-mix(in srgb, var(--sw-ink) 7%, transparent);
  }
  button:disabled {
    color: color-mix(in srgb, var(--sw-ink) 42%, transparent);
    cursor: default;
  }
  button.outlined {
    border-color: var(--sw-line);
    background: var(--sw-raised);
  }
  button.primary {
    background: var(--sw-accent);
    color: var(--sw-on-accent);
    font-weight: 600;
  }
  button.primary:hover:not(:disabled) {
    background: color-mix(in srgb, var(--sw-accent) 88%, var(--sw-ink));
  }
  button.primary:disabled {
    background: color-mix(in srgb, var(--sw-ink) 10%, transparent);
  }
  button[aria-pressed='true'] {
    background: var(--sw-tint);
    border-color: var(--sw-accent);
    color: var(--sw-accent);
  }
  button.icon {
    width: var(--sw-target);
    padding: 0;
  }
  button.link {
    min-height: 0;
    padding: 0;
    border: 0;
    color: var(--sw-accent);
    text-decoration: underline;
    text-underline-offset: 0.15em;
    background: none;
  }
  input[type='number'],
  input[type='text'],
  select {
    width: 100%;
    min-height: var(--sw-target);
    padding: 0 var(--sw-space-2);
    font-size: var(--sw-field-text);
    border: 1px solid var(--sw-line);
    border-radius: var(--sw-radius);
    background: var(--sw-raised);
  }
  input[aria-invalid='true'] {
    border-color: var(--sw-bad);
  }
  input[type='checkbox'],
  input[type='radio'] {
    width: 1rem;
    height: 1rem;
    margin: 0;
    accent-color: var(--sw-accent);
  }
  label {
    display: grid;
    gap: var(--sw-space-1);
    color: var(--sw-soft);
  }
  label.inline {
    display: flex;
    align-items: center;
    gap: var(--sw-space-2);
    color: inherit;
    cursor: pointer;
  }
  @media (pointer: coarse), (width < 40rem) {
    button.link {
      min-height: var(--sw-target);
    }
    label.inline {
      min-height: var(--sw-target);
    }
    input[type='checkbox'],
    input[type='radio'] {
      width: 1.5rem;
      height: 1.5rem;
    }
  }
  :focus-visible {
    outline: 2px solid var(--sw-accent);
    outline-offset: 2px;
  }
  [popover] {
    margin: 0;
    padding: var(--sw-space-4);
    overflow-y: auto;
    border: 1px solid var(--sw-line);
    border-radius: var(--sw-radius);
    background: var(--sw-raised);
    color: var(--sw-ink);
    box-shadow: 0 6px 24px light-dark(rgb(38 40 44 / 0.16), rgb(0 0 0 / 0.5));
  }
  .soft {
    color: var(--sw-soft);
  }
  /* of a seam */
  .letter {
    padding: 0 0.3em;
    border-radius: 3px;
    background: color-mix(in srgb, var(--sw-ink) 9%, transparent);
    color: var(--sw-ink);
    font-size: var(--sw-text);
    font-weight: 600;
    line-height: 1.4;
  }
  .error {
    color: var(--sw-bad);
  }
  .hidden {
    position: absolute;
    width: 1px;
    height: 1px;
    overflow: hidden;
    clip-path: inset(50%);
    white-space: nowrap;
  }
`;
