import type { CustomField } from '@farol/engine/fields';
import type { ReactNode } from 'react';
import type { FieldEditorProps } from '../../api/FieldEditorProps';
import type { PluginFieldType } from '../../api/EditorPlugin';

/** A share: a number from 0 to 1, edited with a slider. */
export const share: PluginFieldType = {
  name: 'share',
  allows: 'a number from 0 to 1',
  check: (value) => typeof value === 'number' && value >= 0 && value <= 1,
  editor: ShareEditor,
};

function ShareEditor({ value, label, description, disabled, ...edit }: FieldEditorProps<CustomField>): ReactNode {
  const shown = typeof value === 'number' ? value : 0;
  return (
    <span style={{ display: 'flex', alignItems: 'center', gap: 8 }}>
      <input
        type="range"
        style={{ flex: 1, minWidth: 0, accentColor: 'var(--accent)' }}
        min={0}
        max={1}
        step={0.01}
        value={shown}
        aria-label={label}
        aria-description={description}
        disabled={disabled}
        onChange={(event) => edit.onPreview(event.target.valueAsNumber)}
        onPointerUp={() => edit.onCommit()}
        onKeyUp={() => edit.onCommit()}
        onBlur={() => edit.onCommit()}
      />
      {Math.round(shown * 100)}%
    </span>
  );
}
