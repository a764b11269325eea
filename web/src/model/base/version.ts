/** Version of this package, equal to the one in package.json, which a browser cannot read. */
export const packageVersion = '0.1.0';
