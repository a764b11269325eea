import type {Plugin} from 'vite';

export const noticesFile: string;
export function notices(): Plugin;
export function workerNotices(): Plugin;
export function siteNotices(): {
  name: string;
  generateBundle: (options: object, bundle: object) => void;
  writeBundle: (options: {dir?: string | undefined}) => void;
};
export function copyNotices(): void;
