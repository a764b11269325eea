/** The package as written by `npm pack`. */
export const tarball: string;

/** Builds the missing or outdated parts, and the parts they are made from. */
export function build(
  ...wanted: readonly (
    'module' | 'scripts' | 'standalone' | 'tarball' | 'page' | 'site' | 'fixtures'
  )[]
): Promise<void>;
