import type {Plugin} from 'vite';

/** Removes the parts of scripts' styles that only readers need. */
export function shortStyles(): Plugin;
