import { t } from '@farol/editing';
import { type ReactNode, useEffect, useRef } from 'react';
import { useEditor, useSignal } from '../../ui/EditorContext';
import './history.css';

/** The steps of the history, oldest first, including undone ones; a click goes to a step. */
export function HistoryPanel(): ReactNode {
  const { commands } = useEditor();
  useSignal(commands.changed);
  const { history, future } = commands;
  const list = useRef<HTMLOListElement>(null);
  useEffect(() => {
    list.current?.querySelector('[aria-current]')?.scrollIntoView({ block: 'nearest' });
    // oxlint-disable-next-line react/exhaustive-effect-dependencies -- scrolls when the current step changes
  }, [history.length]);
  const goTo = (steps: number): void => {
    while (commands.history.length > steps && commands.undo());
    while (commands.history.length < steps && commands.redo());
  };
  const labels = [t('Opened'), ...history, ...future];
  return (
    <section className="panel" aria-label={t('History')}>
      <ol className="history" ref={list}>
        {labels.map((label, steps) => (
          // oxlint-disable-next-line react/no-array-index-key -- a step is identified by its place in the history
          <li key={steps}>
            <button
              type="button"
              className="history-step one-line"
              aria-current={steps === history.length ? 'step' : undefined}
              data-undone={steps > history.length}
              onClick={() => goTo(steps)}
            >
              {label}
            </button>
          </li>
        ))}
      </ol>
    </section>
  );
}
