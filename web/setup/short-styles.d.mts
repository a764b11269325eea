import type {Plugin} from 'vite';

/** Takes out of the styles in scripts what only their readers need. */
export function shortStyles(): Plugin;
