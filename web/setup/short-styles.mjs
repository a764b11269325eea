/** Takes out of the styles in scripts what only their readers need: comments and the room between words. */

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
