import { isComposing, t } from '@farol/editing';
import { useLayoutEffect, useRef, useState } from 'preact/hooks';
import { formatDate } from '../words/format';
import type { RunInfo } from './RunStore';

interface RunItemProps {
  info: RunInfo;
  /** Whether the run is a reference of the repository, which cannot be renamed or deleted. */
  isReference?: boolean;
  /** Ids of the runs chosen for a comparison, at most two. */
  chosen: readonly string[];
  current: string | null;
  onOpen(id: string): Promise<void>;
  onChoose(id: string, isChosen: boolean): void;
  onRename?(name: string): Promise<void>;
  onDelete?(): Promise<void>;
}

export function RunItem(props: RunItemProps) {
  const { info, isReference = false, chosen, current, onOpen, onChoose, onRename, onDelete } = props;
  const [isNaming, setNaming] = useState(false);
  const renameButton = useRef<HTMLButtonElement>(null);
  const title = info.name || t(info.label);
  const endNaming = (name: string | null): void => {
    setNaming(false);
    if (name !== null && name.trim() !== info.name) void onRename?.(name);
    requestAnimationFrame(() => renameButton.current?.focus());
  };
  return (
    <li class="run" aria-current={current === info.id ? 'true' : undefined}>
      <input
        type="checkbox"
        aria-label={t('Compare {title}', { title })}
        checked={chosen.includes(info.id)}
        onChange={({ currentTarget }) => onChoose(info.id, currentTarget.checked)}
      />
      <div class="run-words">
        {isNaming ? (
          <NameField name={info.name} label={info.label} onEnd={endNaming} />
        ) : (
          <button type="button" class="run-open" onClick={() => void onOpen(info.id)}>
            {title}
          </button>
        )}
        {isReference && <span class="badge">{t('reference')}</span>}
        {!info.complete && <span class="badge">{t('not complete')}</span>}
        <p class="run-where">
          {info.name && `${t(info.label)}; `}
          <time dateTime={info.date}>{formatDate(info.date)}</time>; {info.device}; {info.browser}; Farol {info.build}
        </p>
      </div>
      {!isReference && !isNaming && (
        <div class="run-buttons">
          <button
            ref={renameButton}
            type="button"
            aria-label={t('Rename {title}', { title })}
            onClick={() => setNaming(true)}
          >
            {t('Rename')}
          </button>
          <button type="button" aria-label={t('Delete {title}', { title })} onClick={() => void onDelete?.()}>
            {t('Delete')}
          </button>
        </div>
      )}
    </li>
  );
}

/** Field for a run's name. @param onEnd - called once: with the name, or null when cancelled */
function NameField({ name, label, onEnd }: { name: string; label: string; onEnd(name: string | null): void }) {
  const field = useRef<HTMLInputElement>(null);
  const isOver = useRef(false);
  // the field gets the focus before the next frame, so that no key press is lost
  useLayoutEffect(() => {
    field.current?.focus();
    field.current?.select();
  }, []);
  const end = (value: string | null): void => {
    if (isOver.current) return;
    isOver.current = true;
    onEnd(value);
  };
  return (
    <input
      ref={field}
      type="text"
      class="run-name"
      aria-label={t('Name of the run')}
      placeholder={label}
      maxLength={200}
      defaultValue={name}
      onBlur={({ currentTarget }) => end(currentTarget.value)}
      onKeyDown={(event) => {
        if (isComposing(event)) return;
        if (event.key === 'Enter') end(event.currentTarget.value);
        if (event.key === 'Escape') end(null);
      }}
    />
  );
}
