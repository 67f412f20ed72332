import { t } from '@farol/editing';
import type { AssetField } from '@farol/engine/fields';
import { type ReactNode, useMemo, useState } from 'react';
import { draggedAsset, isAssetDrag } from '../files/dragAsset';
import { useEditor, useSignal } from '../ui/EditorContext';
import { SearchSelect } from '../ui/SearchSelect';
import type { FieldEditorProps } from '../api/FieldEditorProps';

const noneOf = (type: AssetField['assetType']): string =>
  ({
    mesh: t('No mesh'),
    texture: t('No texture'),
    material: t('No material'),
    shader: t('No shader'),
    model: t('No model'),
  })[type];

/** The name of an asset: chosen from a list, or dropped from the Assets panel. */
export function AssetEditor(props: FieldEditorProps<AssetField>): ReactNode {
  const { field, value, mixed, label, description, disabled, onCommit } = props;
  const editor = useEditor();
  const { document } = editor;
  useSignal(document.assetsChanged);
  const { assets } = document;
  const { assetType } = field;
  const [isOver, setIsOver] = useState(false);
  const names = assets.list(assetType).join('\n');
  const options = useMemo(
    () =>
      names
        .split('\n')
        .filter(Boolean)
        .map((name) => ({ value: name, label: name })),
    [names],
  );
  const placeholder = mixed ? '—' : noneOf(assetType);
  return (
    <div
      className="asset-slot"
      data-drop={isOver}
      onDragOver={(event) => {
        if (disabled || !isAssetDrag(event.dataTransfer, assetType)) return;
        event.preventDefault();
        event.dataTransfer.dropEffect = 'copy';
        setIsOver(true);
      }}
      onDragLeave={() => setIsOver(false)}
      onDrop={(event) => {
        setIsOver(false);
        const asset = draggedAsset(event.dataTransfer);
        if (disabled || asset?.kind !== assetType) return;
        event.preventDefault();
        editor.attempt(async () => {
          if (!assets.isReady(asset.kind as typeof assetType, asset.name)) await assets.load(asset.name);
          onCommit(asset.name);
        });
      }}
    >
      <SearchSelect {...{ value, options, label, description, disabled, placeholder }} onChange={onCommit} />
    </div>
  );
}
