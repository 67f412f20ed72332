import { Dialog } from '@base-ui/react/dialog';
import { t } from '@farol/editing';
import { type ReactNode, useState } from 'react';
import { type Action, labelOf } from '../../api/Action';
import { allActions } from '../../actions';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';
import { useKeyBindings } from '../../ui/useKeyBindings';
import { SearchInput } from '../../ui/SearchInput';
import { groupOf } from '../palette/paletteItems';
import { matchItems } from '../palette/matchItems';
import { KeyRow } from './KeyRow';
import './keys.css';
import { otherKeys } from './otherKeys';
import { Button } from '../../ui/Button';

/** Every action with its editable keys, and the fixed functions of mouse and other keys. */
export function KeysPage({ onClose }: { onClose(): void }): ReactNode {
  const editor = useEditor();
  const bindings = useKeyBindings();
  const { chosen } = bindings.store.getState();
  useSignal(editor.actions.changed);
  const [query, setQuery] = useState('');
  const lines = allActions(editor).map((action) => ({
    action,
    label: labelOf(action, editor),
    group: groupOf(action.id),
  }));
  const found = matchItems(lines, query);
  const groups = [...new Set(found.map(({ group }) => group))];
  const others = matchItems(
    otherKeys().map(([keys, label]) => ({ keys, label, group: keys })),
    query,
  );
  return (
    <>
      <Dialog.Title>{t('Keys')}</Dialog.Title>
      <div className="keys-bar">
        <div className="keys-search">
          <Icon name="search" size={14} />
          <SearchInput label={t('Search keys')} value={query} onSearch={setQuery} />
        </div>
        <Button label={t('Reset all')} disabled={Object.keys(chosen).length === 0} onClick={() => bindings.reset()} />
      </div>
      {/* oxlint-disable-next-line jsx-a11y/no-noninteractive-tabindex -- a scrolling list must be reachable by keyboard */}
      <div className="keys" tabIndex={0} role="region" aria-label={t('All keys')}>
        {groups.map((group) => (
          <section key={group} aria-label={group}>
            <h3>{group}</h3>
            {found
              .filter((line) => line.group === group)
              .map(({ action, label }: { action: Action; label: string }) => (
                <KeyRow key={action.id} action={action} label={label} />
              ))}
          </section>
        ))}
        {others.length > 0 && (
          <section aria-label={t('Mouse and more')}>
            <h3>{t('Mouse and more')}</h3>
            {others.map(({ keys, label }) => (
              <div key={keys} className="key-row">
                <span>{label}</span>
                <span className="key-other">{keys}</span>
              </div>
            ))}
          </section>
        )}
      </div>
      <div className="dialog-buttons">
        <Button label={t('Close')} onClick={onClose} />
      </div>
    </>
  );
}
