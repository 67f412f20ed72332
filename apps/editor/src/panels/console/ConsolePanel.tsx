import { type ReactNode, useEffect, useRef, useState } from 'react';
import type { ConsoleEntry, ConsoleKind } from '../../model/ConsoleLog';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';
import type { IconName } from '../../style/iconPaths';
import './console.css';

const icons: Readonly<Record<ConsoleKind, IconName>> = { error: 'warning', warning: 'warning', info: 'check' };
const names: Readonly<Record<ConsoleKind, string>> = { error: 'errors', warning: 'warnings', info: 'messages' };
const kinds: readonly ConsoleKind[] = ['error', 'warning', 'info'];
const clock = new Intl.DateTimeFormat('en-GB', { timeStyle: 'medium' });

/** What was said: by shaders, files, assets, components, the picture and the page; the same once, with its count. */
export function ConsolePanel(): ReactNode {
  const { log } = useEditor();
  const revision = useSignal(log.changed);
  const [hidden, setHidden] = useState<ReadonlySet<ConsoleKind>>(new Set());
  const [query, setQuery] = useState('');
  const list = useRef<HTMLUListElement>(null);
  const words = query.toLowerCase();
  const shown = log.entries.filter(
    ({ kind, source, text }) => !hidden.has(kind) && `${source} ${text}`.toLowerCase().includes(words),
  );
  useEffect(() => {
    list.current?.lastElementChild?.scrollIntoView({ block: 'nearest' });
    // oxlint-disable-next-line react/exhaustive-effect-dependencies -- something more was said then
  }, [revision]);
  const toggle = (kind: ConsoleKind): void => {
    const next = new Set(hidden);
    if (!next.delete(kind)) next.add(kind);
    setHidden(next);
  };
  return (
    <section className="panel" aria-label="Console">
      <div className="panel-bar" role="toolbar" aria-label="Console">
        {kinds.map((kind) => (
          <button
            key={kind}
            type="button"
            className="button small"
            aria-pressed={!hidden.has(kind)}
            aria-label={`Show ${names[kind]}`}
            title={`Show ${names[kind]}`}
            onClick={() => toggle(kind)}
          >
            <Icon name={icons[kind]} size={13} />
            {log.count(kind)}
          </button>
        ))}
        <input
          className="input"
          type="search"
          aria-label="Filter messages"
          placeholder="Filter"
          value={query}
          onChange={(event) => setQuery(event.target.value)}
        />
        <button type="button" className="button small" onClick={() => log.clear()}>
          <Icon name="remove" size={13} />
          Clear
        </button>
      </div>
      {shown.length === 0 ? (
        <p className="panel-empty">{log.entries.length === 0 ? 'Nothing was said yet.' : 'Nothing like that.'}</p>
      ) : (
        // oxlint-disable-next-line jsx-a11y/no-noninteractive-tabindex -- a list that scrolls must be reachable by keys
        <ul className="console" ref={list} tabIndex={0} aria-label="Messages">
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
        <button type="button" className="button small" onClick={() => editor.openMicroShader(place.chunk, place.line)}>
          {place.chunk}:{place.line}
        </button>
      )}
      {count > 1 && (
        <span className="console-count" title={`Said ${count} times`}>
          {count}
        </span>
      )}
      <span className="console-source">{source}</span>
      <time className="console-time" dateTime={new Date(time).toISOString()}>
        {clock.format(time)}
      </time>
    </li>
  );
}
