import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import { surfaceEditingOf } from '../../microshaders/SurfaceEditing';
import { useEditor } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';
import { Button } from '../../ui/Button';

export function SurfaceBar({ name }: { name: string }): ReactNode {
  const editor = useEditor();
  const surfaces = surfaceEditingOf(editor);
  const problem = surfaces.problem(name);
  return (
    <div className="panel-bar">
      <strong>{name}</strong>
      <span className="chunk-tag">{t('surface')}</span>
      <span className={problem ? 'chunk-state broken' : 'chunk-state'} role="status">
        {problem && <Icon name="warning" size={12} />}
        {problem ? t('Does not compile: the last valid text is used') : t('Of this scene')}
      </span>
      <span className="panel-space" />
      {problem && (
        <Button look="small" icon="undo" label={t('Last good text')} onClick={() => surfaces.discardDraft(name)} />
      )}
      <Button
        look="small"
        icon="code"
        label={t('Show the asset')}
        onClick={() => editor.document.assetSelection.set([name])}
      />
    </div>
  );
}
