import type {Plugin} from 'vite';

/** Leaves out of three what this project never uses. */
export function leanThree(): Plugin;
