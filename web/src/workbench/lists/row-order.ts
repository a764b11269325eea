/** Sorts rows by one of their columns. */

/** Returns the value to sort by; rows without a value come last. */
export type SortKey<Row> = (row: Row) => number | string | undefined;

export interface Order {
  /** Index of the column. */
  readonly column: number;
  readonly descending: boolean;
}

/** Equal rows keep their order. */
export function inOrder<Row>(
  rows: readonly Row[],
  key: SortKey<Row>,
  descending: boolean,
  language: string,
): readonly Row[] {
  const {compare} = new Intl.Collator(language, {numeric: true});
  const keyed = rows.map((row) => ({row, key: key(row)}));
  const sign = descending ? -1 : 1;
  return keyed
    .sort((one, other) => {
      const [a, b] = [one.key, other.key];
      if (a === undefined || b === undefined)
        return Number(a === undefined) - Number(b === undefined);
      return typeof a === 'number' && typeof b === 'number'
        ? sign * (a - b)
        : sign * compare(String(a), String(b));
    })
    .map(({row}) => row);
}
