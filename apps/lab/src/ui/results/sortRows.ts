import type { RowColumn, TableRow } from './rowColumns';

export interface RowOrder {
  /** Key of the column; `competitor` for the names. */
  readonly key: string;
  readonly isDescending: boolean;
}

/** Sorts rows by a column, then by chart, value and competitor. Rows without a value come last in both directions. */
export function sortRows(
  rows: readonly TableRow[],
  columns: readonly RowColumn[],
  { key, isDescending }: RowOrder,
): TableRow[] {
  const column = columns.find((each) => each.key === key);
  const value = (row: TableRow): number | null => (column ? column.order(row) : row.competitorIndex);
  const sign = isDescending ? -1 : 1;
  return [...rows].sort((a, b) => {
    const [x, y] = [value(a), value(b)];
    if (x === null || y === null) {
      if (x !== y) return x === null ? 1 : -1;
    } else if (x !== y) return (x < y ? -1 : 1) * sign;
    return a.seriesIndex - b.seriesIndex || a.index - b.index || a.competitorIndex - b.competitorIndex;
  });
}
