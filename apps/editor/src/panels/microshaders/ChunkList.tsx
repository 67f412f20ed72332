import { t } from '@farol/editing';
import { type KeyboardEvent, type ReactNode, useEffect, useRef, useState } from 'react';
import type { MicroShaderUses } from '../../microshaders/MicroShaderUses';
import { useEditor } from '../../ui/EditorContext';
import { SURFACE, surfaceEditingOf } from '../../microshaders/SurfaceEditing';
import { Icon } from '../../ui/Icon';
import { SearchInput } from '../../ui/SearchInput';
import { NewChunk } from './NewChunk';
import { XMLMenu } from './XMLMenu';

interface ChunkListProps {
  readonly names: readonly string[];
  /** Names of the surfaces of the scene. */
  readonly surfaces: readonly string[];
  readonly current: string;
  readonly uses: MicroShaderUses;
  onChoose(name: string): void;
}

/** Microshaders by name, the scene's first; edited and broken ones are marked. */
export function ChunkList({ names, surfaces, current, uses, onChoose }: ChunkListProps): ReactNode {
  const editor = useEditor();
  const { microShaders, viewport } = editor;
  const texts = surfaceEditingOf(editor);
  const [query, setQuery] = useState('');
  const list = useRef<HTMLUListElement>(null);
  const words = query.toLowerCase();
  const fits = (name: string): boolean => name.toLowerCase().includes(words);
  const shown = surfaces.filter(fits).map((name) => SURFACE + name);
  const chunks = names
    .filter(fits)
    .toSorted((a, b) => Number(microShaders.isOwn(b)) - Number(microShaders.isOwn(a)) || (a < b ? -1 : 1));
  const found = [...shown, ...chunks];
  const { technique } = viewport.farol.info;
  useEffect(() => {
    list.current?.querySelector('[aria-selected="true"]')?.scrollIntoView({ block: 'nearest' });
    // oxlint-disable-next-line react/exhaustive-effect-dependencies -- scrolls when another one is chosen
  }, [current]);
  const keyDown = (event: KeyboardEvent): void => {
    const at = found.indexOf(current);
    const to = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: found.length - 1 }[event.key];
    if (to === undefined || found.length === 0) return;
    event.preventDefault();
    onChoose(found[Math.min(found.length - 1, Math.max(0, to))]);
  };
  return (
    <div className="chunk-list">
      <div className="panel-bar">
        <SearchInput label={t('Search microshaders')} value={query} onSearch={setQuery} />
        <NewChunk onMade={onChoose} />
        <XMLMenu />
      </div>
      {/* oxlint-disable-next-line jsx-a11y/no-noninteractive-element-to-interactive-role -- a list of options */}
      <ul ref={list} role="listbox" aria-label={t('Microshaders')} tabIndex={0} onKeyDown={keyDown}>
        {found.map((name) => {
          const surface = name.startsWith(SURFACE) ? name.slice(SURFACE.length) : null;
          const problem = surface === null ? microShaders.problem(name) : texts.problem(surface);
          const isInUse = surface !== null || uses.techniquesOf(name).some((each) => each === technique);
          const isOwn = surface === null && microShaders.isOwn(name);
          return (
            <li
              key={name}
              role="option"
              aria-selected={name === current}
              className="chunk-item"
              data-used={isInUse}
              onClick={() => onChoose(name)}
            >
              <span className="chunk-name one-line">{surface ?? name}</span>
              {surface !== null && <span className="chunk-tag">{t('surface')}</span>}
              {isOwn && <span className="chunk-tag">{t('scene')}</span>}
              {surface === null && !isOwn && microShaders.isChanged(name) && (
                <span className="chunk-tag">{t('edited')}</span>
              )}
              {problem && (
                <span className="chunk-broken" title={problem.message}>
                  <Icon name="warning" size={12} />
                  <span className="visually-hidden">{t('broken')}</span>
                </span>
              )}
            </li>
          );
        })}
      </ul>
    </div>
  );
}
