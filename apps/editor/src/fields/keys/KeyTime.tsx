import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import { IconButton } from '../../ui/IconButton';
import { NumberInput } from '../../ui/NumberInput';
import type { TimedKey } from './keyList';
import type { KeyEdit } from './useKeyEdit';

interface KeyTimeProps<K extends TimedKey> {
  readonly edit: KeyEdit<K>;
  readonly label: string;
  readonly removeLabel: string;
  /** Further fields of the key. */
  readonly children?: ReactNode;
}

/** Time of the selected key, its other fields, and a button to remove it. */
export function KeyTime<K extends TimedKey>({ edit, label, removeLabel, children }: KeyTimeProps<K>): ReactNode {
  return (
    <div className="key-fields">
      <span className="key-field-name" aria-hidden="true">
        {t('Time')}
      </span>
      <NumberInput
        value={edit.keys[edit.selected][0]}
        min={0}
        max={1}
        step={0.01}
        digits="short"
        label={label}
        handle={<span className="grip" />}
        onPreview={(next) => edit.change((before) => before.with(0, next) as unknown as K)}
        onCommit={() => edit.end(true)}
        onDiscard={() => edit.end(false)}
      />
      {children}
      <IconButton
        icon="remove"
        label={removeLabel}
        disabled={edit.keys.length < 2}
        onClick={() => edit.remove(edit.selected)}
      />
    </div>
  );
}
