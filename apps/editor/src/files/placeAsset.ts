import { type Command, SetFields, t } from '@farol/editing';
import { GameObject, ModelRenderer, ObjectRenderer } from '@farol/engine';
import type { Vector3Tuple } from '@farol/engine/fields';
import { instanceRootOf } from '@farol/engine/prefabs';
import { Box3, Vector3 } from 'three';
import type { EditorApi } from '../api/EditorApi';
import type { Container } from '../model/commands/Placement';
import { Sequence } from '../model/commands/Sequence';
import { addObject } from '../model/edits';
import { canPlacePrefab, placePrefab } from '../model/prefabEdits';
import { holdsNormals, isEnvironment } from './assetKinds';
import type { DraggedAsset } from './dragAsset';

/** Where something is dropped. */
export interface DropPlace {
  /** What it goes below; the scene when absent. */
  readonly parent?: Container;
  /** Where its foot is, in the world (m); the middle of the picture when absent. Below a parent it is at its origin. */
  readonly point?: Vector3Tuple;
  /** The object under the pointer, for materials and textures. */
  readonly target?: GameObject | null;
}

const stemOf = (name: string): string => name.replace(/^.*\//, '').replace(/\.\w+$/, '') || name;

/** The lowest point of what is drawn (m below its origin, up to 10 km), so that it stands where it is dropped. */
function footOf(editor: EditorApi, { kind, name }: DraggedAsset): number {
  const { assets } = editor.document;
  const box = new Box3();
  if (kind === 'model') box.setFromObject(assets.model(name).scene);
  else if (kind === 'mesh' && assets.isReady('mesh', name)) {
    const geometry = assets.mesh(name);
    if (!geometry.boundingBox) geometry.computeBoundingBox();
    box.copy(geometry.boundingBox!);
  }
  return box.isEmpty() ? 0 : Math.min(1e4, Math.max(-1e4, -box.min.y));
}

function makeObject(editor: EditorApi, { kind, name }: DraggedAsset): GameObject {
  const object = new GameObject(stemOf(name));
  const { assets } = editor.document;
  if (kind === 'model') {
    const [clip] = assets.model(name).animations;
    object.addComponent(ModelRenderer, { model: name, animation: clip?.name ?? '' });
  } else if (kind === 'mesh') {
    object.addComponent(ObjectRenderer, { mesh: name });
  } else if (kind === 'texture') {
    const { width = 1, height = 1 } = assets.texture(name).image as { width?: number; height?: number };
    object.addComponent(ObjectRenderer, { mesh: 'plane', map: name, colour: [1, 1, 1], doubleSided: true });
    object.transform.scale = [width / height, 1, 1];
    object.transform.rotation = [Math.PI / 2, 0, 0];
  } else {
    object.addComponent(ObjectRenderer, { mesh: 'sphere', [kind]: name });
  }
  return object;
}

/** Lights the scene by a texture, and shows it behind. */
export function useAsEnvironment(editor: EditorApi, name: string): void {
  const { settings } = editor.document.scene;
  editor.commands.run(
    new SetFields(t('Light by {name}', { name }), [
      { owner: settings, name: 'environment', value: name },
      { owner: settings, name: 'background', value: 'environment' },
    ]),
  );
}

/** Gives the object under the pointer a material, shader or texture. @returns whether it could */
function paint(editor: EditorApi, { kind, name }: DraggedAsset, target: GameObject | null): boolean {
  const renderer = target?.getComponent(ObjectRenderer);
  if (!renderer) return false;
  const { assets } = editor.document;
  const map = kind === 'texture' && holdsNormals(assets, name) ? 'normalMap' : 'map';
  const shared = kind === 'texture' && renderer.material !== null ? assets.materialAsset(renderer.material) : null;
  if (shared) {
    // a material that others may share keeps the rest of what it is
    const label = t('Give {object} {asset}', { object: shared.name, asset: name });
    editor.commands.run(new SetFields(label, [{ owner: shared, name: map, value: name }]));
    return true;
  }
  const owner = renderer;
  const field = kind === 'texture' ? map : kind;
  const cleared = kind === 'texture' ? ['shader', 'material'] : kind === 'material' ? ['shader'] : [];
  editor.commands.run(
    new SetFields(t('Give {object} {asset}', { object: target!.name, asset: name }), [
      { owner, name: field, value: name },
      ...cleared.map((each) => ({ owner, name: each, value: null })),
    ]),
  );
  editor.document.selection.set([target!.id]);
  return true;
}

/**
 * Brings an asset into the scene: models, meshes and prefabs are placed; environments light the scene; materials, shaders
 * and textures go onto the object under the pointer, or else onto something new.
 * @param then - part of the same step: what becomes of the object that was made
 * @throws Error when a prefab would be placed within itself
 */
export async function placeAsset(
  editor: EditorApi,
  asset: DraggedAsset,
  place: DropPlace = {},
  then?: (object: GameObject) => Command,
): Promise<void> {
  const { document, commands } = editor;
  const { scene, selection } = document;
  const parent = place.parent ?? scene;
  const point = place.point ?? (editor.viewport.editorCamera.target.toArray() as Vector3Tuple);
  if (asset.kind === 'prefab') {
    const prefab = scene.prefabs.get(asset.name);
    if (!prefab) throw new Error(t('This prefab is not in the scene any more.'));
    if (!canPlacePrefab(scene, prefab, parent)) {
      const outer = 'prefabLink' in parent ? instanceRootOf(parent)?.name : '';
      throw new Error(
        t("{name} cannot be placed within itself: '{outer}' is, or holds, an instance of it.", {
          name: prefab.name,
          outer: outer ?? '',
        }),
      );
    }
    commands.run(placePrefab(scene, prefab, parent, selection.ids, parent === scene ? point : undefined));
    return;
  }
  if (!document.assets.isBuiltin(asset.name) || asset.kind === 'model') await document.assets.load(asset.name);
  // of a large mesh the normals take seconds
  if (asset.kind === 'mesh' && document.assets.isReady('mesh', asset.name)) {
    await document.assets.prepareMesh(asset.name);
  }
  if (scene !== document.scene) return;
  if (asset.kind === 'texture' && isEnvironment(asset.name)) return useAsEnvironment(editor, asset.name);
  const paints = asset.kind === 'material' || asset.kind === 'shader' || asset.kind === 'texture';
  if (paints && paint(editor, asset, place.target ?? null)) return;
  const object = makeObject(editor, asset);
  if (parent === scene) {
    const lift = place.point ? new Vector3(0, footOf(editor, asset), 0) : new Vector3();
    object.transform.position = lift.add(new Vector3(...point)).toArray();
  }
  const add = addObject(scene, object, parent, selection.ids);
  commands.run(then ? new Sequence(add.label, [() => add, () => then(object)], add.selection) : add);
}
