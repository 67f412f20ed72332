import { t } from '@farol/editing';
import type { ComponentChildren, RefObject } from 'preact';
import { useMemo, useState } from 'preact/hooks';
import { RunCharts } from '../../charts/RunCharts';
import type { LabRun } from '../../results/LabRun';
import { formatDate } from '../../words/format';
import { deviceName } from '../../words/device';
import { formatDuration } from '../support/formatDuration';
import { Pictures } from './Pictures';
import { RowTable } from './RowTable';
import { whyIncomplete } from './whyIncomplete';

interface ResultsProps {
  run: LabRun;
  /** Whether the run is a reference of the repository. */
  isReference: boolean;
  isRunning: boolean;
  /** Ref of the heading. */
  title: RefObject<HTMLHeadingElement | null>;
  /** Controls for the run. */
  actions: ComponentChildren;
}

/** A run: surroundings, warnings, charts, pictures and rows. */
export function Results({ run, isReference, isRunning, title, actions }: ResultsProps) {
  const runs = useMemo(() => [run], [run]);
  return (
    <>
      <div class="results-head">
        <RunHead {...{ run, isReference, isRunning, title }} />
        {actions}
      </div>
      {run.surroundings.warnings.map((warning) => (
        <p key={warning} class="warning">
          {t(warning)}
        </p>
      ))}
      {run.rows.length > 0 ? (
        <RunCharts key={run.id} runs={runs} />
      ) : (
        <p class="dim">{isRunning ? t('The first figures arrive within seconds.') : t('Nothing was measured.')}</p>
      )}
      {!isRunning && (
        <>
          <section aria-labelledby="pictures-title" class="part">
            <h3 id="pictures-title">{t('What each one drew')}</h3>
            <Pictures run={run} />
          </section>
          <section aria-labelledby="rows-title" class="part">
            <h3 id="rows-title">{t('All measurements')}</h3>
            <AllRows run={run} />
          </section>
        </>
      )}
    </>
  );
}

/** The table of all rows, rendered once opened, since it is by far the largest part of the page. */
function AllRows({ run }: { run: LabRun }) {
  const [isOpen, setOpen] = useState(false);
  return (
    <details class="all-rows" onToggle={({ currentTarget }) => setOpen(currentTarget.open)}>
      <summary>{t('Table of {count} rows, with warnings and what failed', { count: run.rows.length })}</summary>
      {isOpen && <RowTable run={run} />}
    </details>
  );
}

function RunHead({ run, isReference, isRunning, title }: Omit<ResultsProps, 'actions'>) {
  const { name, plan, surroundings, duration } = run;
  const incomplete = whyIncomplete(run);
  return (
    <header class="run-head">
      <h2 id="results-title" ref={title} tabIndex={-1}>
        {isRunning ? t('So far') : name || t(plan.label)}
      </h2>
      {isReference && <span class="badge">{t('reference, not your machine')}</span>}
      {!isRunning && incomplete && <span class="badge">{t('not complete')}</span>}
      <p class="dim">
        {name && `${t(plan.label)}. `}
        {deviceName(surroundings.device)}; {surroundings.browser}, {surroundings.system};{' '}
        <time dateTime={surroundings.date}>{formatDate(surroundings.date)}</time>
        {!isRunning && t('; took {time}', { time: formatDuration(duration) })}
      </p>
      {!isRunning && incomplete && <p class="warning">{incomplete}</p>}
    </header>
  );
}
