/** The Chromium or Chrome that tests drive: that of CHROME_PATH, else the first installed; or null. */
export function chromiumPath(): string | null;
