import { t } from '@farol/editing';
import { useMemo, useState } from 'preact/hooks';
import type { LabRun } from '../../results/LabRun';
import { Select } from '../Select';
import { competitorLabel } from '../../words/names';
import { seriesLabel } from '../../words/seriesLabel';
import { columnsOf, tableRows, type TableRow } from './rowColumns';
import { sortRows, type RowOrder } from './sortRows';

/** A table of all measurements of a run, with problems and warnings. A click on a column's name sorts by the column. */
export function RowTable({ run }: { run: Pick<LabRun, 'plan' | 'rows'> }) {
  const [competitor, setCompetitor] = useState('');
  const [series, setSeries] = useState('');
  const [order, setOrder] = useState<RowOrder>({ key: 'case', isDescending: false });
  const all = useMemo(() => tableRows(run), [run]);
  const columns = useMemo(() => columnsOf(all), [all]);
  const rows = useMemo(() => {
    const matching = all.filter(
      (row) => (competitor === '' || row.competitor === competitor) && (series === '' || row.series === series),
    );
    return sortRows(matching, columns, order);
  }, [all, columns, competitor, series, order]);
  const choose = (key: string): void =>
    setOrder((now) => ({ key, isDescending: now.key === key ? !now.isDescending : false }));
  const head = (key: string, label: string, help: string, isText: boolean) => (
    <th
      key={key}
      scope="col"
      class={isText ? 'text' : undefined}
      aria-sort={order.key === key ? (order.isDescending ? 'descending' : 'ascending') : undefined}
    >
      <button type="button" class="sort" title={help} onClick={() => choose(key)}>
        {label}
        <span aria-hidden="true">{order.key === key ? (order.isDescending ? ' ▾' : ' ▴') : ''}</span>
      </button>
    </th>
  );
  return (
    <>
      <div class="filters">
        <Select
          label={t('Competitor')}
          value={competitor}
          options={[['', t('All')], ...run.plan.competitors.map((name) => [name, competitorLabel(name)] as const)]}
          onChange={setCompetitor}
        />
        <Select
          label={t('Chart')}
          value={series}
          options={[['', t('All')], ...run.plan.series.map((series) => [series.name, seriesLabel(series)] as const)]}
          onChange={setSeries}
        />
        <p class="count" role="status">
          {rows.length === all.length
            ? t('{count} rows', { count: all.length })
            : t('{count} of {all} rows', { count: rows.length, all: all.length })}
        </p>
      </div>
      <div class="table-scroll" role="region" aria-label={t('All rows')} tabIndex={0}>
        <table class="rows">
          <thead>
            <tr>
              {head('competitor', t('Competitor'), t('Technique or renderer that drew.'), true)}
              <th scope="col" class="text remarks">
                {t('Remarks')}
              </th>
              {columns.map(({ key, label, help, isText }) => head(key, t(label), t(help), isText ?? false))}
            </tr>
          </thead>
          <tbody>
            {rows.map((row) => (
              <tr key={`${row.series} ${row.index} ${row.competitor}`} class={row.problem ? 'without' : undefined}>
                <th scope="row">{row.label}</th>
                <td class="text remarks">
                  <Remarks row={row} />
                </td>
                {columns.map((column) => (
                  <td key={column.key} class={column.isText ? 'text' : undefined}>
                    {column.text(row)}
                  </td>
                ))}
              </tr>
            ))}
          </tbody>
        </table>
      </div>
    </>
  );
}

function Remarks({ row }: { row: TableRow }) {
  const { problem, warnings, technique, reason, dropped } = row;
  return (
    <>
      {problem && <p class="problem">{problem}</p>}
      {warnings.map((warning) => (
        <p key={warning} class="warning">
          {warning}
        </p>
      ))}
      {dropped > 0 && warnings.length === 0 && (
        <p class="warning">{t('{count} lights are left out of its picture.', { count: dropped })}</p>
      )}
      {technique && (
        <p class="dim">
          {competitorLabel(technique)}
          {reason ? `: ${t(reason)}` : ''}
        </p>
      )}
    </>
  );
}
