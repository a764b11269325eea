import type {Plugin} from 'vite';

/** Removes what only readers need from the styles and HTML in scripts. */
export function shortTemplates(): Plugin;
