import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import { useEditor } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';
import { Button } from '../../ui/Button';

/** Name, state and buttons of a microshader. */
export function ChunkBar({ name, onOpen }: { name: string; onOpen(name: string): void }): ReactNode {
  const editor = useEditor();
  const { microShaders } = editor;
  const problem = microShaders.problem(name);
  const isOwn = microShaders.isOwn(name);
  const isChanged = microShaders.isChanged(name);
  const stage = microShaders.registry.get(name)?.stage;
  const state = problem
    ? t('Does not compile: the last valid text is used')
    : isOwn
      ? t('Of this scene')
      : isChanged
        ? t('Edited in this scene')
        : t('As built in');
  return (
    <div className="panel-bar">
      <strong>{name}</strong>
      {stage && stage !== 'both' && <span className="chunk-tag">{stage}</span>}
      <span className={problem ? 'chunk-state broken' : 'chunk-state'} role="status">
        {problem && <Icon name="warning" size={12} />}
        {state}
      </span>
      <span className="panel-space" />
      {problem && (
        <Button look="small" icon="undo" label={t('Last good text')} onClick={() => microShaders.discardDraft(name)} />
      )}
      {isChanged && (
        <Button
          look="small"
          icon={isOwn ? 'remove' : 'undo'}
          label={isOwn ? t('Delete') : t('Revert to built in')}
          onClick={() =>
            editor.attempt(() => {
              microShaders.revert(name);
              if (isOwn) onOpen(microShaders.names[0]);
            })
          }
        />
      )}
    </div>
  );
}
