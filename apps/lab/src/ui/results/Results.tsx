import type { ComponentChildren } from 'preact';
import type { LabRun } from '../../results/LabRun';
import { formatDuration } from '../support/formatDuration';
import { deviceName } from '../support/deviceName';
import { Pictures } from './Pictures';
import { RowTable } from './RowTable';

interface ResultsProps {
  run: LabRun;
  /** Whether the run lies in the repository, made by somebody else. */
  isReference: boolean;
  isRunning: boolean;
  /** Charts of the run. */
  children: ComponentChildren;
  /** Buttons for the run. */
  actions: ComponentChildren;
}

/** A run: where it was made, what spoils it, its charts, pictures and rows. */
export function Results({ run, isReference, isRunning, children, actions }: ResultsProps) {
  return (
    <>
      <RunHead run={run} isReference={isReference} isRunning={isRunning} />
      {actions}
      {run.surroundings.warnings.map((warning) => (
        <p key={warning} class="warning">
          {warning}
        </p>
      ))}
      {children}
      {!isRunning && (
        <>
          <section aria-labelledby="pictures-title" class="part">
            <h3 id="pictures-title">What each one drew</h3>
            <Pictures run={run} />
          </section>
          <section aria-labelledby="rows-title" class="part">
            <h3 id="rows-title">All figures</h3>
            <RowTable run={run} />
          </section>
        </>
      )}
    </>
  );
}

function RunHead({ run, isReference, isRunning }: { run: LabRun; isReference: boolean; isRunning: boolean }) {
  const { name, plan, surroundings, complete, duration } = run;
  const date = new Date(surroundings.date);
  return (
    <header class="run-head">
      <h2 id="results-title" tabIndex={-1}>
        {isRunning ? 'So far' : name || plan.label}
        {isReference && <span class="badge">reference, not your machine</span>}
        {!isRunning && !complete && <span class="badge">not complete</span>}
      </h2>
      <p class="dim">
        {name && `${plan.label}. `}
        {deviceName(surroundings.device)}; {surroundings.browser}, {surroundings.system};{' '}
        <time dateTime={surroundings.date}>
          {Number.isNaN(date.getTime()) ? surroundings.date : date.toLocaleString('en', dateStyle)}
        </time>
        {!isRunning && `; took ${formatDuration(duration)}`}
      </p>
      {!isRunning && !complete && (
        <p class="warning">This run was cancelled: what was measured until then is kept and shown.</p>
      )}
    </header>
  );
}

const dateStyle = { dateStyle: 'medium', timeStyle: 'short' } as const;
