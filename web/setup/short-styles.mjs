/** Removes comments and whitespace, which only readers need, from the styles in scripts. */

const styles = /(?<=\bcss`)[^`]*(?=`)/g;

export const shortStyles = () => ({
  name: 'seamwise-short-styles',
  apply: 'build',
  enforce: 'pre',
  transform(code, id) {
    if (!/[\\/]web[\\/]src[\\/].*\.ts$/.test(id) || !code.includes('css`')) return null;
    const short = code.replaceAll(styles, (style) =>
      style
        .replaceAll(/\/\*.*?\*\//gs, '')
        .replaceAll(/\s+/g, ' ')
        .replaceAll(/ ?([{};]) ?/g, '$1'),
    );
    return {code: short, map: null};
  },
});
