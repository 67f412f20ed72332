import { t } from '@farol/editing';
import type { ChartTable } from './ChartSpec';

/** A chart's values as a table that scrolls sideways if it is too wide. */
export function ChartTableView({ table, caption }: { table: ChartTable; caption: string }) {
  return (
    <div class="chart-table-scroll" role="region" aria-label={t('Table: {title}', { title: caption })} tabIndex={0}>
      <table>
        <caption class="chart-spoken">{caption}</caption>
        <thead>
          <tr>
            {table.columns.map((column, i) => (
              <th key={i} scope="col">
                {column}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {table.rows.map((row, i) => (
            <tr key={i}>
              {row.map((cell, k) =>
                k === 0 ? (
                  <th key={k} scope="row">
                    {cell}
                  </th>
                ) : (
                  <td key={k}>{cell}</td>
                ),
              )}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
