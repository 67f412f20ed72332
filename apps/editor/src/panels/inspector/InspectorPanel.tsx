import { isComposing, t, wordsOfFilter } from '@farol/editing';
import { type FocusEvent, type PointerEvent, type ReactNode, useDeferredValue, useMemo, useState } from 'react';
import { draggedAsset, isAssetDrag } from '../../files/dragAsset';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { FieldFilter } from '../../ui/FieldFilter';
import './inspector.css';
import { AssetInspector } from '../material/AssetInspector';
import { fieldSearchOf } from './fieldSearch';
import { ObjectInspector } from './ObjectInspector';
import { SceneInspector } from './SceneInspector';

/** Fields of the selection, and below them the help of the hovered or focused field. */
export function InspectorPanel(): ReactNode {
  const editor = useEditor();
  const { document } = editor;
  useSignal(document.selection.changed);
  useSignal(document.assetSelection.changed);
  useSignal(document.opened);
  const [{ help, of: helpOf }, showHelp] = useState<{ help: string; of: unknown }>({ help: '', of: null });
  const search = fieldSearchOf(editor);
  useSignal(search.changed);
  const { text: filter } = search;
  const words = useMemo(() => wordsOfFilter(filter), [filter]);
  // the ids are deferred, so that moving through the tree with a held key does not wait for the inspector
  const ids = useDeferredValue(document.selection.ids);

  const asset = document.assetSelection.primary;
  // help shown for a previous selection is hidden
  const subject = asset ?? ids;
  const setHelp = (text: string): void => showHelp({ help: text, of: subject });
  const show = (event: PointerEvent | FocusEvent): void => {
    const field = (event.target as HTMLElement).closest<HTMLElement>('[data-help]');
    setHelp(field?.dataset.help ?? '');
  };

  const ofObjects = ids.length > 0 ? <ObjectInspector ids={ids} /> : <SceneInspector />;
  const content = asset === null ? ofObjects : <AssetInspector key={asset} name={asset} />;

  return (
    <section
      className="panel inspector"
      aria-label={t('Inspector')}
      aria-busy={ids !== document.selection.ids}
      onDragOver={(event) => {
        if (asset !== null || ids.length === 0 || !isAssetDrag(event.dataTransfer, 'script')) return;
        event.preventDefault();
        event.dataTransfer.dropEffect = 'copy';
      }}
      onDrop={(event) => {
        const dropped = draggedAsset(event.dataTransfer);
        if (event.defaultPrevented || dropped?.kind !== 'script' || ids.length === 0) return;
        event.preventDefault();
        editor.attempt(async () => {
          const { addScriptComponent } = await import('../../model/scriptEdits');
          editor.commands.run(addScriptComponent(document.scene, document.selectedObjects, dropped.name));
        });
      }}
      onPointerOver={show}
      onFocus={show}
      onBlur={() => setHelp('')}
      // touch does not hide the help: on touch screens the browser sends pointerleave after each tap
      onPointerLeave={({ pointerType }) => pointerType !== 'touch' && setHelp('')}
    >
      <header className="panel-header">
        <input
          className="input search"
          type="search"
          value={filter}
          placeholder={t('Find a field')}
          aria-label={t('Find a field')}
          autoComplete="off"
          spellCheck={false}
          onChange={(event) => search.find(event.target.value)}
          onKeyDown={(event) => {
            if (isComposing(event) || event.key !== 'Escape') return;
            event.stopPropagation();
            search.find('');
            event.currentTarget.blur();
          }}
        />
      </header>
      <div
        key={asset !== null ? 'asset' : ids.length > 0 ? 'objects' : 'scene'}
        className="inspector-body"
        data-filtered={words.length > 0}
      >
        <FieldFilter value={words}>{content}</FieldFilter>
        <p className="inspector-none">{t('No field matches the search.')}</p>
      </div>
      <p className="inspector-help">{helpOf === subject ? help : ''}</p>
    </section>
  );
}
