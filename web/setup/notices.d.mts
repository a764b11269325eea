import type {Plugin} from 'vite';

export const noticesFile: string;
export function notices(): Plugin;
export function workerNotices(): Plugin;
export function copyNotices(): void;
