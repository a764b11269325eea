/** The package as `npm pack` writes it. */
export const tarball: string;

/** Builds the parts that are missing or out of date, and those that they are made from. */
export function build(
  ...wanted: readonly ('module' | 'scripts' | 'standalone' | 'tarball' | 'page' | 'fixtures')[]
): Promise<void>;
