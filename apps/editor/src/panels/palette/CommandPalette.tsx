import { isComposing, t } from '@farol/editing';
import { Dialog } from '@base-ui/react/dialog';
import { type KeyboardEvent, type ReactNode, useCallback, useEffect, useMemo, useRef, useState } from 'react';
import { showPalette } from '../../actions/help';
import { matchKey } from '../../actions/matchKey';
import { useEditor } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';
import { keyText } from '../../ui/keyText';
import { matchItems } from './matchItems';
import './palette.css';
import { componentItems, fieldItems } from './fieldItems';
import { LINES, objectItems, OBJECTS, type PaletteItem, paletteItems } from './paletteItems';

/** Palette of all actions, and of the scene's objects, searched by typing. */
export function CommandPalette({ onClose }: { onClose(): void }): ReactNode {
  const editor = useEditor();
  const [query, setQuery] = useState('');
  // `typed` is read when this field replaces the one typed into before, which React may do 0.3 s after the render
  const begin = useCallback(
    (input: HTMLInputElement | null) => {
      input?.focus();
      if (input) setQuery(editor.dialogs.typed);
    },
    [editor],
  );
  const [chosen, setChosen] = useState(0);
  const list = useRef<HTMLUListElement>(null);
  const items = useMemo(() => paletteItems(editor), [editor]);
  const objects = useMemo(() => objectItems(editor), [editor]);
  const fields = useMemo(() => [...componentItems(editor), ...fieldItems(editor)], [editor]);
  const found = useMemo(() => {
    if (query.trim() === '') return items.slice(0, LINES);
    const named = matchItems(objects, query).slice(0, OBJECTS);
    return [...matchItems([...items, ...fields], query).slice(0, LINES), ...named];
  }, [items, fields, objects, query]);
  const current = Math.min(chosen, found.length - 1);
  useEffect(() => {
    list.current?.children[current]?.scrollIntoView({ block: 'nearest' });
  }, [current]);

  const run = (item: PaletteItem | undefined): void => {
    if (!item) return;
    onClose();
    // the command runs in the next frame, when the focus has returned to the element that had it before the palette
    requestAnimationFrame(() => editor.attempt(() => item.run()));
  };
  const keyDown = (event: KeyboardEvent): void => {
    if (isComposing(event)) return;
    const by = { ArrowDown: 1, ArrowUp: -1, PageDown: 10, PageUp: -10 }[event.key];
    if (event.key === 'Enter') run(found[current]);
    else if (editor.keys.keysOf(showPalette).some((keys) => matchKey(keys, event))) onClose();
    else if (by !== undefined && found.length > 0) {
      const isStep = Math.abs(by) === 1;
      const next = current + by;
      setChosen(isStep ? (next + found.length) % found.length : Math.min(found.length - 1, Math.max(0, next)));
    } else return;
    event.preventDefault();
  };

  return (
    <>
      <Dialog.Title className="palette-title">{t('Search commands')}</Dialog.Title>
      <div className="palette-search">
        <Icon name="search" />
        <input
          className="palette-input"
          role="combobox"
          aria-label={t('Search commands')}
          aria-expanded
          aria-controls="palette-list"
          aria-activedescendant={found[current] ? `palette-${current}` : undefined}
          aria-autocomplete="list"
          placeholder={t('A command, a field, a panel, a sample, something to add, an object')}
          autoComplete="off"
          spellCheck={false}
          value={query}
          onChange={(event) => {
            setQuery(event.target.value);
            setChosen(0);
          }}
          onKeyDown={keyDown}
          ref={begin}
        />
      </div>
      <ul id="palette-list" className="palette-list" role="listbox" aria-label={t('Commands')} ref={list}>
        {found.map((item, i) => (
          <li
            key={item.id}
            id={`palette-${i}`}
            className="palette-item"
            role="option"
            aria-selected={i === current}
            onPointerMove={() => i !== current && setChosen(i)}
            onClick={() => run(item)}
          >
            <span className="menu-check">
              {(item.isCurrent || item.icon) && <Icon name={item.isCurrent ? 'check' : item.icon!} size={14} />}
            </span>
            <span className="palette-label one-line">{item.label}</span>
            <span className="dim">{item.group}</span>
            {item.keys && <kbd>{keyText(item.keys)}</kbd>}
          </li>
        ))}
      </ul>
      {found.length === 0 && <p className="palette-empty">{t('Nothing matches the search.')}</p>}
    </>
  );
}
