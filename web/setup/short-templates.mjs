/**
 * Removes what only readers need from the templates in scripts: comments and whitespace of styles,
 * and the indentation of HTML.
 */

const styles = /(?<=\bcss`)[^`]*(?=`)/g;

export const shortTemplates = () => ({
  name: 'seamwise-short-templates',
  apply: 'build',
  enforce: 'pre',
  transform(code, id) {
    if (!/[\\/]web[\\/]src[\\/].*\.ts$/.test(id) || !/\b(?:css|html)`/.test(code)) return null;
    const short = code
      .replaceAll(styles, (style) =>
        style
          .replaceAll(/\/\*.*?\*\//gs, '')
          .replaceAll(/\s+/g, ' ')
          .replaceAll(/ ?([{};]) ?/g, '$1'),
      )
      .replaceAll(/\n +/g, '\n');
    return {code: short, map: null};
  },
});
