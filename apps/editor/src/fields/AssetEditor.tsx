import { t } from '@farol/editing';
import type { AssetLibrary } from '@farol/engine';
import { type AssetField, type MaterialMap, materialMaps } from '@farol/engine/fields';
import { type ReactNode, useMemo } from 'react';
import { assetEntries, type AssetEntry, holdsNormals } from '../files/assetKinds';
import { draggedAsset, isAssetDrag } from '../files/dragAsset';
import { useEditor, useSignal } from '../ui/EditorContext';
import { LatePolarCurve } from '../ui/lateAssetParts';
import { type SearchOption, SearchSelect } from '../ui/SearchSelect';
import { Thumbnail } from '../ui/Thumbnail';
import { useDropTarget } from '../ui/useDropTarget';
import type { FieldEditorProps } from '../api/FieldEditorProps';

interface AssetOption extends SearchOption {
  readonly entry: AssetEntry;
}

/** Label of an asset in the list; parts of models begin with their own name, before the model's. */
function nameOf({ name, kind, label, model, isBuiltin }: AssetEntry): string {
  if (model !== null) return `${label} (${model})`;
  return kind === 'prefab' || isBuiltin ? label : name;
}

const noneOf = (type: AssetField['assetType']): string =>
  ({
    mesh: t('No mesh'),
    texture: t('No texture'),
    material: t('Own material'),
    shader: t('No shader'),
    model: t('No model'),
    script: t('No script'),
    clip: t('No clip'),
    sound: t('No sound'),
    profile: t('No profile'),
    surface: t('No surface'),
    bake: t('No baked light'),
  })[type];

/** Sort rank of an asset: textures of the kind that the field needs (normal map or not), then others, then variants. */
function rankOf(assets: AssetLibrary, entry: AssetEntry, isForNormals: boolean | null): number {
  if (entry.isVariant) return 2;
  return isForNormals === null || holdsNormals(assets, entry.name) === isForNormals ? 0 : 1;
}

/** Whether a field takes a normal map; null when it is not a map of a material. */
function isForNormals(name: string): boolean | null {
  const map: MaterialMap | undefined = (materialMaps as Readonly<Record<string, MaterialMap>>)[name];
  return map ? (map.isNormals ?? false) : null;
}

/** Chooses an asset from a list with thumbnails, or by a drop from the Assets panel. */
export function AssetEditor(props: FieldEditorProps<AssetField>): ReactNode {
  const { field, name, value, mixed, label, description, disabled, onCommit } = props;
  const editor = useEditor();
  const { document } = editor;
  const revision = useSignal(document.assetsChanged);
  const { scene, assets } = document;
  const { assetType } = field;
  const options = useMemo((): AssetOption[] => {
    const normals = assetType === 'texture' ? isForNormals(name) : null;
    const rank = ({ entry }: AssetOption): number => rankOf(assets, entry, normals);
    return assetEntries(scene)
      .filter(({ kind }) => kind === assetType)
      .map((entry) => ({ value: entry.name, label: nameOf(entry), entry }))
      .toSorted((a, b) => rank(a) - rank(b));
    // oxlint-disable-next-line react-hooks/exhaustive-deps -- the revision changes with the library
  }, [scene, assets, assetType, name, revision]);
  const placeholder = mixed ? '—' : noneOf(assetType);
  const pictureOf = (option: SearchOption): ReactNode => {
    const { entry } = option as Partial<AssetOption>;
    return entry && <Thumbnail entry={entry} size={14} />;
  };
  const target = useDropTarget(
    (dragged) => !disabled && isAssetDrag(dragged, assetType),
    (data) => {
      const asset = draggedAsset(data);
      if (asset?.kind !== assetType) return;
      editor.attempt(async () => {
        if (!assets.isReady(asset.kind as typeof assetType, asset.name)) await assets.load(asset.name);
        onCommit(asset.name);
      });
    },
  );
  return (
    <div className="asset-slot" {...target}>
      <SearchSelect {...{ value, options, label, description, disabled, placeholder, pictureOf }} onChange={onCommit} />
      {assetType === 'profile' && value !== null && <LatePolarCurve name={value} />}
    </div>
  );
}
