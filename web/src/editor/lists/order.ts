/** Rows by what stands in one of their columns. */

/** What rows are sorted by; those without it come last. */
export type SortKey<Row> = (row: Row) => number | string | undefined;

export interface Order {
  /** The number of the column. */
  readonly column: number;
  readonly descending: boolean;
}

/** Rows that are equal stay as they are. */
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
