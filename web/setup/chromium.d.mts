/** The Chromium or Chrome for tests: that of CHROME_PATH, else the first installed; or null. */
export function chromiumPath(): string | null;
