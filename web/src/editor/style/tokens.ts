/** The type scale, the spacing scale and the quiet colours of all parts. */
import {css} from 'lit';

export const tokens = css`
  :host {
    --sw-text: 0.8125rem;
    --sw-text-large: 0.9375rem;
    --sw-text-title: 1.375rem;
    --sw-space-1: 0.25rem;
    --sw-space-2: 0.5rem;
    --sw-space-3: 0.75rem;
    --sw-space-4: 1rem;
    --sw-space-6: 1.5rem;
    --sw-radius: 8px;
    /* what is pressed is as high, so that a finger finds it */
    --sw-target: 2rem;
    --sw-field-text: var(--sw-text);
    --sw-ground: light-dark(#f6f5f3, #17181b);
    --sw-paper: light-dark(#fdfcfb, #1f2024);
    --sw-raised: light-dark(#ffffff, #292b30);
    --sw-ink: light-dark(#26282c, #eceded);
    --sw-soft: light-dark(#5f6268, #a9acb3);
    --sw-line: light-dark(#dfddd8, #36383e);
    --sw-strong-line: light-dark(#8c8f95, #7c7f87);
    --sw-accent: light-dark(#24507a, #9cc3ea);
    --sw-on-accent: light-dark(#ffffff, #10202f);
    --sw-tint: light-dark(#e6edf4, #26323f);
    --sw-bad: light-dark(#a92a22, #ff9c92);
    --sw-bad-tint: light-dark(#fbeae8, #3b2322);
    font:
      400 var(--sw-text) / 1.45 var(--sw-font, system-ui),
      system-ui,
      -apple-system,
      'Segoe UI',
      Roboto,
      'Helvetica Neue',
      'Liberation Sans',
      sans-serif;
    font-variant-numeric: tabular-nums;
    color: var(--sw-ink);
  }
  @media (pointer: coarse), (width < 40rem) {
    :host {
      --sw-target: 2.75rem;
      --sw-field-text: 1rem; /* below that, phones zoom into a field */
    }
  }
`;
