import { t } from '@farol/editing';
import { useCallback, useMemo, useRef, useState } from 'preact/hooks';
import { messageOf } from '../run/messageOf';
import { importRuns } from './importRuns';
import type { LabRun } from './LabRun';
import type { ReferenceRun } from './referenceRuns';
import { RunItem } from './RunItem';
import type { RunStore } from './RunStore';
import { useFileDrop } from './useFileDrop';
import { useRuns } from './useRuns';
import './results.css';

interface RunLibraryProps {
  store: RunStore;
  references?: readonly ReferenceRun[];
  current: string | null;
  onOpen(run: LabRun): void;
  onCompare(a: LabRun, b: LabRun): void;
  onRename?(id: string, name: string): void;
}

interface Deleted {
  readonly name: string;
  readonly undo: () => Promise<void>;
}

const none: readonly ReferenceRun[] = [];

/** List of kept runs: to open, rename, delete, import, and compare two of them. */
export function RunLibrary({ store, references = none, current, onOpen, onCompare, onRename }: RunLibraryProps) {
  const kept = useRuns(store);
  const [problems, setProblems] = useState<readonly string[]>([]);
  const [deleted, setDeleted] = useState<Deleted | null>(null);
  const [chosen, setChosen] = useState<readonly string[]>([]);
  const input = useRef<HTMLInputElement>(null);
  const undoButton = useRef<HTMLButtonElement>(null);

  const attempt = useCallback(async (act: () => Promise<void>) => {
    setProblems([]);
    try {
      await act();
    } catch (error) {
      setProblems([messageOf(error)]);
    }
  }, []);

  const importFiles = useCallback(
    (files: File[]) =>
      attempt(async () => {
        const { runs, problems } = await importRuns(files, store);
        setProblems(problems);
        const last = runs.at(-1);
        if (last) onOpen(last);
      }),
    [store, onOpen, attempt],
  );
  const isOver = useFileDrop(useCallback((files: File[]) => void importFiles(files), [importFiles]));

  const readers = useMemo(() => {
    const ofReferences = references.map(({ info, read }) => [info.id, read] as const);
    const ofKept = (kept.runs ?? []).map(({ id }) => [id, () => store.open(id)] as const);
    return new Map([...ofReferences, ...ofKept]);
  }, [references, kept.runs, store]);
  const pair = chosen.filter((id) => readers.has(id));
  const choose = (id: string, isChosen: boolean): void =>
    setChosen(isChosen ? [...pair.filter((each) => each !== id), id].slice(-2) : pair.filter((each) => each !== id));

  const open = (id: string) => attempt(async () => onOpen(await readers.get(id)!()));
  const compare = () =>
    attempt(async () => {
      const [a, b] = await Promise.all(pair.map((id) => readers.get(id)!()));
      onCompare(a, b);
    });
  const rename = (id: string, name: string) =>
    attempt(async () => {
      await store.rename(id, name);
      onRename?.(id, name.trim());
    });
  const remove = (id: string, name: string) =>
    attempt(async () => {
      setDeleted({ name, undo: await store.remove(id) });
      // moves the focus, since the focused button no longer exists
      requestAnimationFrame(() => undoButton.current?.focus());
    });
  const undo = () =>
    attempt(async () => {
      await deleted?.undo();
      setDeleted(null);
    });

  const row = { chosen: pair, current, onOpen: open, onChoose: choose };
  return (
    <section class={isOver ? 'library dropping' : 'library'} aria-labelledby="library-title">
      <div class="library-head">
        <h2 id="library-title">{t('Saved runs')}</h2>
        <div class="library-buttons">
          <button
            type="button"
            disabled={pair.length < 2}
            aria-describedby="compare-needs"
            onClick={() => void compare()}
          >
            {t('Compare two')}
          </button>
          <button type="button" onClick={() => input.current?.click()}>
            {t('Import JSON…')}
          </button>
          <input
            ref={input}
            class="library-file"
            type="file"
            accept=".json,application/json"
            multiple
            aria-label={t('Runs to import')}
            tabIndex={-1}
            onChange={({ currentTarget }) => {
              void importFiles([...(currentTarget.files ?? [])]);
              currentTarget.value = '';
            }}
          />
        </div>
      </div>
      <p id="compare-needs" class="dim" hidden={pair.length === 2 || readers.size < 2}>
        {t('To compare two runs, check the boxes before them.')}
      </p>
      <div role="alert">
        {[...problems, ...(kept.problem === null ? [] : [kept.problem])].map((problem) => (
          <p key={problem} class="problem">
            {problem}
          </p>
        ))}
      </div>
      {deleted && (
        <p class="library-undo" role="status">
          {t('Deleted “{name}”.', { name: deleted.name })}{' '}
          <button ref={undoButton} type="button" onClick={() => void undo()}>
            {t('Undo')}
          </button>
        </p>
      )}
      <ul class="runs" aria-label={t('Runs')}>
        {kept.runs?.map((info) => (
          <RunItem
            key={info.id}
            info={info}
            {...row}
            onRename={(name) => rename(info.id, name)}
            onDelete={() => remove(info.id, info.name || info.label)}
          />
        ))}
        {references.map(({ info }) => (
          <RunItem key={info.id} info={info} isReference {...row} />
        ))}
      </ul>
      {kept.runs?.length === 0 && (
        <p class="dim">
          {t(
            'Runs of yours are kept in this browser and listed here. Choose two to compare them, or drop another machine’s JSON anywhere on the page.',
          )}
        </p>
      )}
    </section>
  );
}
