import { type Command, SetFields, t } from '@farol/editing';
import {
  Animation,
  AudioSource,
  GameObject,
  Light,
  lightShadows,
  meshShadows,
  ModelRenderer,
  ObjectRenderer,
} from '@farol/engine';
import { instanceRootOf, instantiatePrefab } from '@farol/engine/prefabs';
import type { EditorApi } from '../api/EditorApi';
import type { Container } from '../model/commands/Placement';
import { Sequence } from '../model/commands/Sequence';
import { addComponent, addObject } from '../model/edits';
import { canPlacePrefab } from '../model/prefabEdits';
import { holdsNormals, isEnvironment } from './assetKinds';
import type { DraggedAsset } from './dragAsset';
import { landInPicture } from './landInPicture';

/** Place where an asset is dropped. */
export interface DropPlace {
  /** Parent of the new object; the scene when absent. */
  readonly parent?: Container;
  /** Page position (CSS pixels); the centre of the viewport when absent. Below a parent the object is at the parent's origin. */
  readonly at?: { readonly x: number; readonly y: number };
  /** Object under the pointer, for assets that are assigned to objects. */
  readonly target?: GameObject | null;
}

const stemOf = (name: string): string => name.replace(/^.*\//, '').replace(/\.\w+$/, '') || name;

function makeObject(editor: EditorApi, { kind, name }: DraggedAsset): GameObject {
  const object = new GameObject(stemOf(name));
  const { assets } = editor.document;
  if (kind === 'model') {
    const [clip] = assets.model(name).clips;
    object.addComponent(ModelRenderer, { model: name });
    if (clip) object.addComponent(Animation, { clip: assets.nameOf(clip) });
  } else if (kind === 'clip') {
    object.addComponent(Animation, { clip: name });
  } else if (kind === 'sound') {
    object.addComponent(AudioSource, { sound: name });
  } else if (kind === 'profile') {
    object.addComponent(Light, { type: 'point', intensity: 12, range: 10, ...lightShadows.point, profile: name });
  } else if (kind === 'mesh') {
    object.addComponent(ObjectRenderer, { mesh: name, ...meshShadows });
  } else if (kind === 'texture') {
    const { width = 1, height = 1 } = assets.texture(name).image as { width?: number; height?: number };
    object.addComponent(ObjectRenderer, {
      mesh: 'plane',
      map: name,
      colour: [1, 1, 1],
      doubleSided: true,
      ...meshShadows,
    });
    object.transform.scale = [width / height, 1, 1];
    object.transform.rotation = [Math.PI / 2, 0, 0];
  } else {
    object.addComponent(ObjectRenderer, { mesh: 'sphere', [kind]: name, ...meshShadows });
  }
  return object;
}

/** Uses a texture as the scene's environment and background. */
export function useAsEnvironment(editor: EditorApi, name: string): void {
  const { settings } = editor.document.scene;
  editor.commands.run(
    new SetFields(t('Lit the scene by {name}', { name }), [
      { owner: settings, name: 'environment', value: name },
      { owner: settings, name: 'background', value: 'environment' },
    ]),
  );
}

function animate(editor: EditorApi, clip: string, target: GameObject): void {
  const { document, commands } = editor;
  const owner = target.getComponent(Animation);
  const label = t('Gave {asset} to {object}', { object: target.name, asset: clip });
  if (owner) commands.run(new SetFields(label, [{ owner, name: 'clip', value: clip }]));
  else commands.run(addComponent(document.scene, [target], Animation, { clip }));
  document.selection.set([target.id]);
}

/** Makes an object play a sound, in its first AudioSource that has none, else in a new AudioSource. */
function sound(editor: EditorApi, name: string, target: GameObject): void {
  const { document, commands } = editor;
  const owner = target.getComponents(AudioSource).find((each) => each.getAuthored('sound') === null);
  const label = t('Gave {asset} to {object}', { object: target.name, asset: name });
  if (owner) commands.run(new SetFields(label, [{ owner, name: 'sound', value: name }]));
  else commands.run(addComponent(document.scene, [target], AudioSource, { sound: name }));
  document.selection.set([target.id]);
}

/** Assigns a material, shader or texture to an object. @returns whether it could be assigned */
function paint(editor: EditorApi, { kind, name }: DraggedAsset, target: GameObject | null): boolean {
  const renderer = target?.getComponent(ObjectRenderer);
  if (!renderer) return false;
  const { assets } = editor.document;
  const map = kind === 'texture' && holdsNormals(assets, name) ? 'normalMap' : 'map';
  const shared = kind === 'texture' && renderer.material !== null ? assets.materialAsset(renderer.material) : null;
  if (shared) {
    // the library material gets the map, for all objects that share it, and keeps its other values
    const label = t('Gave {asset} to {object}', { object: shared.name, asset: name });
    editor.commands.run(new SetFields(label, [{ owner: shared, name: map, value: name }]));
    return true;
  }
  const owner = renderer;
  const field = kind === 'texture' ? map : kind;
  const cleared = kind === 'texture' ? ['shader', 'material'] : kind === 'material' ? ['shader'] : [];
  editor.commands.run(
    new SetFields(t('Gave {asset} to {object}', { object: target!.name, asset: name }), [
      { owner, name: field, value: name },
      ...cleared.map((each) => ({ owner, name: each, value: null })),
    ]),
  );
  editor.document.selection.set([target!.id]);
  return true;
}

/** Assigns a photometric profile to a point or spot light. @returns whether the object has such a light */
function shape(editor: EditorApi, profile: string, target: GameObject | null): boolean {
  const owner = target?.getComponent(Light);
  if (!owner || (owner.type !== 'point' && owner.type !== 'spot')) return false;
  const label = t('Gave {asset} to {object}', { object: target!.name, asset: profile });
  editor.commands.run(new SetFields(label, [{ owner, name: 'profile', value: profile }]));
  editor.document.selection.set([target!.id]);
  return true;
}

/** Adds a component of a script to an object; without a drop target the script is opened. */
async function useScript(editor: EditorApi, script: string, place: DropPlace): Promise<void> {
  if (place.target === undefined) return editor.openScript(script);
  if (place.target === null)
    throw new Error(t('Drop {name} on an object, which then gets it as a component.', { name: script }));
  const { addScriptComponent } = await import('../model/scriptEdits');
  const { document, commands } = editor;
  commands.run(addScriptComponent(document.scene, [place.target], script));
  document.selection.set([place.target.id]);
}

/** Makes an object use a surface; without a drop target the surface's text is opened. */
async function useSurface(editor: EditorApi, surface: string, place: DropPlace): Promise<void> {
  if (place.target === undefined) return editor.openMicroShader(`surface:${surface}`);
  const { surfaceWearers, wearSurface } = await import('../model/surfaceEdits');
  const users = surfaceWearers(place.target ? [place.target] : []);
  if (users.length === 0)
    throw new Error(t('Drop {name} on an object with a mesh, which then gets it.', { name: surface }));
  const { document, commands } = editor;
  commands.run(wearSurface(surface, users));
  document.selection.set([place.target!.id]);
}

/**
 * Adds an asset to the scene. Models, meshes and prefabs are placed; environment maps light the scene; materials,
 * shaders, textures, photometric profiles, clips and sounds are assigned to the object under the pointer, or else to a
 * new one; scripts and surfaces to the object under the pointer, or else they are opened.
 * @param then - makes further edits of the new object, as part of the same step
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
  if (asset.kind === 'library') {
    const { placeLibraryItem } = await import('./library/placeLibraryItem');
    return placeLibraryItem(editor, asset.name, place);
  }
  if (asset.kind === 'script') return useScript(editor, asset.name, place);
  if (asset.kind === 'surface') return useSurface(editor, asset.name, place);
  const parent = place.parent ?? scene;
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
    const instance = instantiatePrefab(prefab, scene.registry);
    if (parent === scene) await landInPicture(editor, [instance], place.at);
    if (scene === document.scene) commands.run(addObject(scene, instance, parent, selection.ids));
    return;
  }
  if (!document.assets.isBuiltin(asset.name) || asset.kind === 'model') await document.assets.load(asset.name);
  // prepared before the object is added, since computing normals of a large mesh takes seconds
  if (asset.kind === 'mesh' && document.assets.isReady('mesh', asset.name)) {
    await document.assets.prepareMesh(asset.name);
  }
  if (scene !== document.scene) return;
  if (asset.kind === 'texture' && isEnvironment(asset.name)) return useAsEnvironment(editor, asset.name);
  if (asset.kind === 'clip' && place.target) return animate(editor, asset.name, place.target);
  if (asset.kind === 'sound' && place.target) return sound(editor, asset.name, place.target);
  if (asset.kind === 'profile' && shape(editor, asset.name, place.target ?? null)) return;
  const paints = asset.kind === 'material' || asset.kind === 'shader' || asset.kind === 'texture';
  if (paints && paint(editor, asset, place.target ?? null)) return;
  const object = makeObject(editor, asset);
  if (parent === scene) await landInPicture(editor, [object], place.at);
  if (scene !== document.scene) return;
  const add = addObject(scene, object, parent, selection.ids);
  commands.run(then ? new Sequence(add.label, [() => add, () => then(object)], add.selection) : add);
}
