import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import { draggedAsset, isAssetDrag } from '../../files/dragAsset';
import { canMove, moveAssets } from '../../model/assetEdits';
import { useEditor } from '../../ui/EditorContext';
import { useDropTarget } from '../../ui/useDropTarget';

interface FolderTargetProps {
  readonly folder: string;
  readonly className: string;
  readonly children: ReactNode;
  onOpen(folder: string): void;
}

/** A folder, opened by a click; assets can be dropped into it. */
export function FolderTarget({ folder, className, children, onOpen }: FolderTargetProps): ReactNode {
  const editor = useEditor();
  const target = useDropTarget(isAssetDrag, (data) => {
    const asset = draggedAsset(data);
    if (!asset) return;
    editor.attempt(() => {
      const { document, commands } = editor;
      const names = (asset.names ?? [asset.name]).filter((name) => canMove(document.scene, name));
      if (names.length === 0)
        throw new Error(
          t('{name} stays where it is: it came with Farol, or is a part of a model.', { name: asset.name }),
        );
      commands.run(moveAssets(document.scene, names, folder));
    });
  });
  return (
    <button
      type="button"
      className={className}
      data-folder={folder}
      title={t('Open it, or drop assets into it')}
      onClick={() => onOpen(folder)}
      {...target}
    >
      {children}
    </button>
  );
}
