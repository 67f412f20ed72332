import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import { canRename, joinName, splitName } from '../../model/assetNames';
import { renameAnyAsset } from '../../model/scriptEdits';
import { assetEntry } from '../../files/assetKinds';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';
import { IconButton } from '../../ui/IconButton';
import { LatePolarCurve, LateSoundButton } from '../../ui/lateAssetParts';
import { TextInput } from '../../ui/TextInput';
import { assetIcons, Thumbnail } from '../../ui/Thumbnail';
import { AssetFacts } from './AssetFacts';
import { MaterialInspector } from './MaterialInspector';
import { ScriptAssetBar } from './ScriptAssetBar';
import { SurfaceAssetBar } from './SurfaceAssetBar';
import { UsedBy } from './UsedBy';
import './material.css';

/** Inspector of the asset selected in the Assets panel: name, fields or facts, and users. */
export function AssetInspector({ name }: { name: string }): ReactNode {
  const editor = useEditor();
  const { document, commands } = editor;
  useSignal(document.assetsChanged);
  useSignal(document.prefabs);
  const { scene, assets } = document;
  const material = assets.materialAsset(name);
  const isScript = assets.fieldAsset(name)?.type === 'script';
  const isSurface = assets.surface(name) !== null;
  const entry = assetEntry(scene, name);
  if (!entry) return null;
  const { folder, leaf } = splitName(name);
  const rename = (next: string): void =>
    editor.attempt(() => {
      const to = joinName(folder, next.trim());
      if (!next.trim() || to === name) return;
      const command = renameAnyAsset(scene, name, to);
      commands.run(command);
      document.assetSelection.set([assets.has(to) ? to : name]);
    });
  return (
    <>
      <div className="object-header">
        <Icon name={assetIcons[entry.kind]} />
        {canRename(assets, name) ? (
          <TextInput value={leaf} label={t('Name of the asset')} onCommit={rename} />
        ) : (
          <span className="object-count">{entry.label}</span>
        )}
        <IconButton
          icon="close"
          label={t('Close the asset')}
          title={t('Show what is selected in the scene')}
          onClick={() => document.assetSelection.clear()}
        />
      </div>
      {isScript && <ScriptAssetBar name={name} />}
      {isSurface && <SurfaceAssetBar name={name} />}
      {material && <MaterialInspector material={material} />}
      {!isScript && !isSurface && !material && (
        <>
          <div className="asset-large">
            {entry.kind === 'profile' ? <LatePolarCurve name={name} /> : <Thumbnail entry={entry} />}
            {entry.kind === 'sound' && <LateSoundButton name={name} />}
          </div>
          <AssetFacts entry={entry} />
        </>
      )}
      <UsedBy name={name} />
    </>
  );
}
