import { t, tCount } from '@farol/editing';
import type { ReactNode } from 'react';
import { addScriptComponent } from '../../model/scriptEdits';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';

/** Buttons for a script asset, the component type that it defines, and its errors. */
export function ScriptAssetBar({ name }: { name: string }): ReactNode {
  const editor = useEditor();
  const { document, commands } = editor;
  useSignal(document.scripts.changed);
  useSignal(document.selection.changed);
  const source = document.assets.fieldAsset(name)?.get('source') as string;
  const objects = document.selectedObjects;
  const error = document.scripts.errors.get(name);
  const lines = source.split('\n').length;
  return (
    <div className="script-asset">
      <button type="button" className="button framed" onClick={() => editor.openScript(name)}>
        <Icon name="code" />
        <span>{t('Edit ## the text of a script')}</span>
      </button>
      <button
        type="button"
        className="button framed"
        disabled={objects.length === 0}
        onClick={() => editor.attempt(() => commands.run(addScriptComponent(document.scene, objects, name)))}
      >
        <Icon name="add" />
        <span>{t('Add to the selected objects')}</span>
      </button>
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
