/** The Chromium or Chrome that tests drive: that of CHROME_PATH, else the first installed; or null. */
export function chromiumPath(): string | null;

/** Chromium without windows where there is one, else the other; or null. */
export function headlessPath(): string | null;
