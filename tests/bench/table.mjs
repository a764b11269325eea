// Formats a table of figures.

export const ms = (value) => (value < 9.95 ? value.toFixed(1) : value.toFixed(0));
export const fit = (value) => value.toFixed(value < 9.995 ? 2 : 1);
export const megabytes = (bytes) => (bytes / 1e6).toFixed(1);
export const kilobytes = (bytes) => (bytes / 1e3).toFixed(1);
export const share = (value) =>
  value === null ? '=' : Number.isFinite(value) ? digits(value) : 'inf';
export const millimetres = (cm) => (10 * cm).toFixed(1);
export const digits = (value) =>
  value < 0.0995 ? value.toFixed(4) : value < 99.5 ? value.toFixed(3) : value.toFixed(0);

/** @param head  titles; the first column is text, the others are figures */
export function table(head, rows) {
  const all = [head, ...rows].map((row) => row.map(String));
  const widths = head.map((_, k) => Math.max(3, ...all.map((row) => row[k].length)));
  const line = (cells) =>
    `| ${cells.map((cell, k) => (k === 0 ? cell.padEnd(widths[k]) : cell.padStart(widths[k]))).join(' | ')} |`;
  const rule = widths.map((width, k) =>
    k === 0 ? '-'.repeat(width) : `${'-'.repeat(width - 1)}:`,
  );
  return [line(all[0]), `| ${rule.join(' | ')} |`, ...all.slice(1).map(line)].join('\n');
}
