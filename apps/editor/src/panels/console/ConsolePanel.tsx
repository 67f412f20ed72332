import { formatTime, t } from '@farol/editing';
import { type ReactNode, useEffect, useRef, useState } from 'react';
import type { ConsoleEntry, ConsoleKind, ConsoleSource } from '../../model/ConsoleLog';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';
import { SearchInput } from '../../ui/SearchInput';
import type { IconName } from '../../style/iconPaths';
import './console.css';
import { Button } from '../../ui/Button';

const icons: Readonly<Record<ConsoleKind, IconName>> = { error: 'warning', warning: 'warning', info: 'check' };
const showLabel = (kind: ConsoleKind): string =>
  ({ error: t('Show errors'), warning: t('Show warnings'), info: t('Show messages') })[kind];

const sourceLabel = (source: ConsoleSource): string =>
  ({
    editor: t('editor'),
    shader: t('shader'),
    file: t('file'),
    asset: t('asset'),
    component: t('component'),
    script: t('script'),
    picture: t('picture'),
    plugin: t('plugin'),
    page: t('page'),
  })[source];

const kinds: readonly ConsoleKind[] = ['error', 'warning', 'info'];

/**
 * Messages of shaders, files, assets, components, the viewport and the page; repeated ones are shown once with a count.
 */
export function ConsolePanel(): ReactNode {
  const { log } = useEditor();
  const revision = useSignal(log.changed);
  const [hidden, setHidden] = useState<ReadonlySet<ConsoleKind>>(new Set());
  const [query, setQuery] = useState('');
  const list = useRef<HTMLUListElement>(null);
  const words = query.toLowerCase();
  const shown = log.entries.filter(
    ({ kind, source, text }) => !hidden.has(kind) && `${sourceLabel(source)} ${text}`.toLowerCase().includes(words),
  );
  useEffect(() => {
    list.current?.lastElementChild?.scrollIntoView({ block: 'nearest' });
    // oxlint-disable-next-line react/exhaustive-effect-dependencies -- scrolls when a message is added
  }, [revision]);
  const toggle = (kind: ConsoleKind): void => {
    const next = new Set(hidden);
    if (!next.delete(kind)) next.add(kind);
    setHidden(next);
  };
  return (
    <section className="panel" aria-label={t('Console')}>
      <div className="panel-bar" role="toolbar" aria-label={t('Console')}>
        {kinds.map((kind) => (
          <button
            key={kind}
            type="button"
            className="button small"
            aria-pressed={!hidden.has(kind)}
            aria-label={showLabel(kind)}
            title={showLabel(kind)}
            onClick={() => toggle(kind)}
          >
            <Icon name={icons[kind]} size={13} />
            {log.count(kind)}
          </button>
        ))}
        <SearchInput label={t('Filter messages')} placeholder={t('Filter')} value={query} onSearch={setQuery} />
        <Button look="small" icon="remove" label={t('Clear')} onClick={() => log.clear()} />
      </div>
      {shown.length === 0 ? (
        <p className="panel-empty">
          {log.entries.length === 0 ? t('No messages yet.') : t('No message matches the filter.')}
        </p>
      ) : (
        // oxlint-disable-next-line jsx-a11y/no-noninteractive-tabindex -- a scrolling list must be reachable by keyboard
        <ul className="console" ref={list} tabIndex={0} aria-label={t('Messages')}>
          {shown.map((entry) => (
            <ConsoleLine key={entry.id} entry={entry} />
          ))}
        </ul>
      )}
    </section>
  );
}

function ConsoleLine({ entry }: { entry: ConsoleEntry }): ReactNode {
  const editor = useEditor();
  const { kind, source, text, count, time, place } = entry;
  return (
    <li className={`console-line ${kind}`}>
      <Icon name={icons[kind]} size={13} />
      <span className="console-text">{text}</span>
      {place && (
        <Button
          look="small"
          label={`${'script' in place ? place.script : place.chunk}:${place.line}`}
          onClick={() => {
            if ('script' in place) editor.openScript(place.script, place.line);
            else editor.openMicroShader(place.chunk, place.line);
          }}
        />
      )}
      {count > 1 && (
        <span className="console-count" title={t('Repeated {count} times', { count })}>
          {count}
        </span>
      )}
      <span className="console-source">{sourceLabel(source)}</span>
      <time className="console-time" dateTime={new Date(time).toISOString()}>
        {formatTime(time)}
      </time>
    </li>
  );
}
