/** A number of things, such as "1 piece" or "2 pieces". */
export const countOf = (count: number, thing: string): string =>
  `${count} ${thing}${count === 1 ? '' : 's'}`;
