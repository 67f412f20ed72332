import { tCount } from '@farol/editing';
import type { ReactNode } from 'react';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { scriptEntries } from '../assets/assetMenu';
import { Icon } from '../../ui/Icon';
import { Button } from '../../ui/Button';

/** Buttons for a script asset, the component type that it defines, and its errors. */
export function ScriptAssetBar({ name }: { name: string }): ReactNode {
  const editor = useEditor();
  const { document } = editor;
  useSignal(document.scripts.changed);
  useSignal(document.selection.changed);
  const source = document.assets.fieldAsset(name)?.get('source') as string;
  const error = document.scripts.errors.get(name);
  const lines = source.split('\n').length;
  return (
    <div className="script-asset">
      {scriptEntries(editor, name).map(({ label, icon, disabled, run }) => (
        <Button key={label} {...{ label, icon, disabled }} onClick={run} />
      ))}
      <p className="asset-note">{tCount(lines, '{count} line', '{count} lines')}</p>
      {error && (
        <p className="script-error">
          <Icon name="warning" size={12} />
          <button type="button" className="link" onClick={() => editor.openScript(name, error.line)}>
            {name}:{error.line}
          </button>
          <span>{error.problem}</span>
        </p>
      )}
    </div>
  );
}
