import { t } from '@farol/editing';
import { type FocusEvent, type PointerEvent, type ReactNode, useDeferredValue, useState } from 'react';
import { useEditor, useSignal } from '../../ui/EditorContext';
import './inspector.css';
import { AssetInspector } from '../material/AssetInspector';
import { ObjectInspector } from './ObjectInspector';
import { SceneInspector } from './SceneInspector';

/** The values of what is selected; below them the help of the field under the pointer, or with the focus. */
export function InspectorPanel(): ReactNode {
  const { document } = useEditor();
  useSignal(document.selection.changed);
  useSignal(document.assetSelection.changed);
  useSignal(document.opened);
  const [help, setHelp] = useState('');
  // who walks through the tree by a key that is held down waits for the tree alone
  const ids = useDeferredValue(document.selection.ids);

  const show = (event: PointerEvent | FocusEvent): void => {
    const field = (event.target as HTMLElement).closest<HTMLElement>('[data-help]');
    setHelp(field?.dataset.help ?? '');
  };

  const asset = document.assetSelection.primary;
  const ofObjects = ids.length > 0 ? <ObjectInspector ids={ids} /> : <SceneInspector />;
  const content = asset === null ? ofObjects : <AssetInspector key={asset} name={asset} />;

  return (
    <section
      className="panel inspector"
      aria-label={t('Inspector')}
      aria-busy={ids !== document.selection.ids}
      onPointerOver={show}
      onFocus={show}
      onPointerLeave={() => setHelp('')}
    >
      <div key={asset === null ? 'objects' : 'asset'} className="inspector-body">
        {content}
      </div>
      <p className="inspector-help">{help}</p>
    </section>
  );
}
