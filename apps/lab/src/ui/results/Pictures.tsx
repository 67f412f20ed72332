import { t } from '@farol/editing';
import { useMemo, useState } from 'preact/hooks';
import type { LabRun } from '../../results/LabRun';
import { caseText } from '../../words/names';
import { Select } from '../Select';
import { PictureDialog } from './PictureDialog';
import { psnrText, tableRows, type TableRow } from './rowColumns';

/** Pictures of a case by all competitors, with their likeness to the reference. */
export function Pictures({ run }: { run: Pick<LabRun, 'plan' | 'rows'> }) {
  const rows = useMemo(() => tableRows(run).filter(({ likeness }) => likeness?.thumbnail), [run]);
  const cases = useMemo(() => [...new Set(rows.map(caseKey))], [rows]);
  const [chosen, setChosen] = useState<string | null>(null);
  const [large, setLarge] = useState<TableRow | null>(null);
  if (rows.length === 0) return <p class="dim">{t('This run keeps no pictures.')}</p>;
  const current = chosen !== null && cases.includes(chosen) ? chosen : cases[cases.length - 1];
  const those = rows.filter((row) => caseKey(row) === current).sort((a, b) => a.competitorIndex - b.competitorIndex);
  const options = cases.map((key) => {
    const { seriesLabel, seriesIndex, index } = rows.find((row) => caseKey(row) === key)!;
    return [key, `${seriesLabel}: ${caseText(run.plan.series[seriesIndex], index)}`] as const;
  });
  return (
    <>
      <div class="filters">
        <Select label={t('Case')} value={current} options={options} onChange={setChosen} />
      </div>
      <ul class="pictures">
        {those.map((row) => (
          <li key={row.competitor}>
            <button type="button" class="picture" onClick={() => setLarge(row)}>
              <img
                src={row.likeness!.thumbnail}
                alt=""
                width={160}
                height={(160 * row.labCase.height) / row.labCase.width}
              />
              <span>{row.label}</span>
              <span class="dim">{likenessText(row)}</span>
            </button>
          </li>
        ))}
      </ul>
      {large && (
        <PictureDialog
          plan={run.plan}
          row={large}
          reference={those.find(({ competitor }) => competitor === large.likeness!.reference) ?? null}
          onClose={() => setLarge(null)}
        />
      )}
    </>
  );
}

const caseKey = ({ series, index }: TableRow): string => `${series} ${index}`;

function likenessText({ competitor, likeness, dropped }: TableRow): string {
  const left = dropped > 0 ? `, ${t('{count} lights left out', { count: dropped })}` : '';
  if (competitor === likeness!.reference) return `${t('the reference')}${left}`;
  return likeness!.psnr === null ? `${t('equal to the reference')}${left}` : `${psnrText(likeness)} dB${left}`;
}
