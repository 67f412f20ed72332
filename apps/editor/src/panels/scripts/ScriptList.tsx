import { isComposing, t } from '@farol/editing';
import { type KeyboardEvent, type ReactNode, useEffect, useRef, useState } from 'react';
import { joinName, splitName } from '../../model/assetNames';
import { renameScript } from '../../model/scriptEdits';
import { useEditor } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';
import { MenuButton } from '../../ui/MenuButton';
import { SearchInput } from '../../ui/SearchInput';
import { newScript } from '../../files/newScript';
import { templateEntries } from '../assets/folderMenu';
import { removeScript, scriptMenu } from './scriptActions';

interface ScriptListProps {
  readonly names: readonly string[];
  readonly current: string | null;
  /** Whether the present text of a script has a syntax error. */
  isBroken(name: string): boolean;
}

/** The scene's scripts in their folders, to add, rename, copy and delete. */
export function ScriptList({ names, current, isBroken }: ScriptListProps): ReactNode {
  const editor = useEditor();
  const [query, setQuery] = useState('');
  const [renamed, setRenamed] = useState<string | null>(null);
  const list = useRef<HTMLUListElement>(null);
  const words = query.toLowerCase();
  const found = names.filter((name) => name.toLowerCase().includes(words));
  useEffect(() => {
    list.current?.querySelector('[aria-selected="true"]')?.scrollIntoView({ block: 'nearest' });
    // oxlint-disable-next-line react/exhaustive-effect-dependencies -- scrolls when another one is chosen
  }, [current]);

  const finishRename = (name: string, typed: string | null): void => {
    setRenamed(null);
    list.current?.focus();
    const leaf = typed?.trim() ?? '';
    if (leaf === '' || leaf === splitName(name).leaf) return;
    editor.attempt(() => {
      const to = joinName(splitName(name).folder, leaf);
      editor.commands.run(renameScript(editor.document.scene, name, to));
      editor.openScript(to);
    });
  };
  const keyDown = (event: KeyboardEvent): void => {
    if (event.target !== event.currentTarget || found.length === 0) return;
    const at = current === null ? -1 : found.indexOf(current);
    const to = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: found.length - 1 }[event.key];
    if (to !== undefined) editor.openScript(found[Math.min(found.length - 1, Math.max(0, to))]);
    else if (event.key === 'F2' && current !== null) setRenamed(current);
    else if (event.key === 'Delete' && current !== null) editor.attempt(() => removeScript(editor, current));
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    <div className="chunk-list">
      <div className="panel-bar">
        <SearchInput label={t('Search scripts')} value={query} onSearch={setQuery} />
        <MenuButton
          label={t('New script')}
          icon="add"
          iconOnly
          className="button small"
          entries={() => [
            { label: t('Empty script'), icon: 'code', run: () => editor.attempt(() => newScript(editor)) },
            'separator',
            ...templateEntries(editor, ''),
          ]}
        />
        <MenuButton
          label={t('Menu of the script')}
          icon="more"
          iconOnly
          className="button small"
          disabled={current === null}
          entries={() => (current === null ? [] : scriptMenu(editor, current, () => setRenamed(current)))}
        />
      </div>
      {/* oxlint-disable-next-line jsx-a11y/no-noninteractive-element-to-interactive-role -- a list of options */}
      <ul ref={list} role="listbox" aria-label={t('Scripts')} tabIndex={0} onKeyDown={keyDown}>
        {found.map((name) => {
          const { folder, leaf } = splitName(name);
          return (
            <li
              key={name}
              role="option"
              aria-selected={name === current}
              aria-label={isBroken(name) ? t('{name}, broken', { name }) : name}
              className="chunk-item"
              data-used="true"
              title={name}
              onClick={() => editor.openScript(name)}
              onDoubleClick={() => setRenamed(name)}
            >
              {name === renamed ? (
                <NameInput name={leaf} onDone={(typed) => finishRename(name, typed)} />
              ) : (
                <span className="chunk-name one-line">
                  {folder !== '' && <span className="script-folder">{folder}/</span>}
                  {leaf}
                </span>
              )}
              {isBroken(name) && (
                <span className="chunk-broken">
                  <Icon name="warning" size={12} />
                </span>
              )}
            </li>
          );
        })}
      </ul>
    </div>
  );
}

/** Field for renaming a script. @param props.onDone - called with the new name, or null when cancelled */
function NameInput({ name, onDone }: { name: string; onDone(typed: string | null): void }): ReactNode {
  const isDone = useRef(false);
  const done = (typed: string | null): void => {
    if (isDone.current) return;
    isDone.current = true;
    onDone(typed);
  };
  return (
    <input
      ref={(input) => input?.focus()}
      className="input rename"
      aria-label={t('Name of {name}', { name })}
      defaultValue={name}
      autoComplete="off"
      spellCheck={false}
      onClick={(event) => event.stopPropagation()}
      onFocus={(event) => event.currentTarget.select()}
      onBlur={(event) => done(event.currentTarget.value)}
      onKeyDown={(event) => {
        event.stopPropagation();
        if (isComposing(event)) return;
        if (event.key === 'Enter') done(event.currentTarget.value);
        else if (event.key === 'Escape') done(null);
      }}
    />
  );
}
