import { type Command, namesOf, t } from '@farol/editing';
import { Camera as CameraComponent, type GameObject, Light, ObjectRenderer, type Scene } from '@farol/engine';
import { instantiatePrefab, type Prefab } from '@farol/engine/prefabs';
import { type Camera, Ray, Vector3 } from 'three';
import type { EditorApi } from '../../api/EditorApi';
import { bringAssets, type BroughtAssets, renamedObjects } from '../../model/bringAssets';
import { AddAssets } from '../../model/commands/AddAssets';
import { Sequence } from '../../model/commands/Sequence';
import { SetPrefab } from '../../model/commands/SetPrefab';
import { SetProperty } from '../../model/commands/SetProperty';
import { giveMaterial } from '../../model/assetEdits';
import { addObject } from '../../model/edits';
import { addLibraryScript } from '../../model/library/addLibraryScript';
import { buildLibraryItem } from '../../model/library/buildLibraryItem';
import type { LibraryMaterial } from '../../model/library/materials';
import { libraryNames } from '../../model/library/names';
import { type BuiltItem, materialAsset } from '../../model/library/parts';
import { skies } from '../../model/library/skies';
import { surfacesAlong } from '../../viewport/placing/surfaces';
import type { DropPlace } from '../placeAsset';
import { giveSky } from './giveSky';
import { type Brought, placeInstance } from './placeInstance';

/** A prefab's objects, with assets and component types renamed to their names in a scene. */
function namedObjects(scene: Scene, prefab: Prefab, brought: BroughtAssets): Prefab['objects'] {
  return renamedObjects(scene, prefab.objects, brought, {}).map((object) => ({
    ...object,
    components: object.components.map((component) => {
      const [type, method] = String(component.values.method ?? '').split('.');
      const next = brought.types.get(type);
      return next ? { ...component, values: { ...component.values, method: `${next}.${method}` } } : component;
    }),
  }));
}

/** Prefab of an item for a scene, with the commands that add the prefab, materials and scripts that the scene lacks. */
export function bringItem(scene: Scene, { prefab, assets }: BuiltItem): Brought {
  const known = scene.prefabs.get(prefab.id);
  if (known) return { prefab: known, steps: [] };
  const brought = bringAssets(scene, assets, new Map());
  const named = { ...prefab, objects: namedObjects(scene, prefab, brought) };
  const add = () => new AddAssets(scene.assets, brought.taken);
  const set = () => new SetPrefab(scene, named.id, named);
  return { prefab: named, steps: brought.taken.length > 0 ? [add, set] : [set] };
}

/** Whether the surface below an object has a collider, on its object or on an ancestor. */
function isCarried(scene: Scene, { transform }: GameObject, camera: Camera): boolean {
  const [x, y, z] = transform.position;
  const ray = new Ray(new Vector3(x, y + 0.5, z), new Vector3(0, -1, 0));
  const [below] = surfacesAlong(scene, ray, camera);
  if (!below || below.distance > 1) return false;
  for (let each = below.object; each; each = each.parent) if (each.getComponent('Collider')) return true;
  return false;
}

/** Commands after a player was added: the player's camera becomes the scene's; a ground is added when none is below. */
function stepsOfPlayer(scene: Scene, player: GameObject, camera: Camera): (() => Command)[] {
  const steps: (() => Command)[] = [];
  if (!isCarried(scene, player, camera)) {
    const ground = bringItem(scene, buildLibraryItem('ground')!);
    const object = instantiatePrefab(ground.prefab, scene.registry);
    object.transform.position = player.transform.position;
    steps.push(...ground.steps, () => addObject(scene, object, scene, []));
  }
  const eyes = (): Command => {
    const eye = scene.componentsOf(CameraComponent).find(({ gameObject }) => gameObject.parent === player) ?? null;
    const label = t('Set the camera of the scene to {name}', { name: eye?.gameObject.name ?? t('none') });
    return new SetProperty(label, [scene], 'activeCamera', eye);
  };
  return [...steps, eyes];
}

/** Whether an object or a descendant has a light. */
function shines(object: GameObject): boolean {
  let found = false;
  object.traverse((each) => void (found ||= each.getComponent(Light) !== null));
  return found;
}

/** Assigns a material to the object that it is dropped on, or else to the selected ones. */
function giveLibraryMaterial({ document, commands }: EditorApi, name: LibraryMaterial, { target }: DropPlace): void {
  const { scene, selectedObjects } = document;
  const objects = target === undefined ? selectedObjects : target === null ? [] : [target];
  const users = objects.flatMap((object) => object.getComponent(ObjectRenderer) ?? []);
  if (users.length === 0)
    throw new Error(t('Drop {name} on an object with a mesh, or select one first.', { name: t(name) }));
  const asset = materialAsset(name);
  const { taken, names } = bringAssets(scene, [asset], new Map());
  const label = t('Gave {asset} to {object}', {
    ...{ asset: t(name), object: namesOf(users.map(({ gameObject }) => gameObject)) },
  });
  const give = (): Command => giveMaterial(users, names.get(asset.name) ?? asset.name, label);
  commands.run(new Sequence(label, taken.length > 0 ? [() => new AddAssets(scene.assets, taken), give] : [give]));
}

/**
 * Places an instance of a library's item, as one undo step; the first instance brings the item's prefab, materials and
 * scripts into the scene. 'flicker' makes selected lamps flicker; a sky is given to the scene, a material to objects.
 * @param id - such as 'street-lamp' or 'material/Brass'
 */
export async function placeLibraryItem(editor: EditorApi, id: string, place: DropPlace = {}): Promise<void> {
  const { document, commands } = editor;
  const { scene, selection } = document;
  if (/^(own|folder)\//.test(id)) {
    const { placeOwnItem } = await import('./ownLibrary');
    return placeOwnItem(editor, id, place);
  }
  const lamps = document.selectedObjects.filter(shines);
  if (id === 'flicker' && lamps.length > 0 && !place.at && !place.parent)
    return commands.run(addLibraryScript(scene, lamps, 'Flicker'));
  if (id.startsWith('material/')) return giveLibraryMaterial(editor, id.slice(9) as LibraryMaterial, place);
  if (Object.hasOwn(skies, id)) {
    const sky = id as keyof typeof skies;
    return commands.run(giveSky(scene, t(libraryNames.sky[sky]), skies[sky], selection.ids));
  }
  const item = buildLibraryItem(id);
  if (!item) throw new Error(t('The library no longer has this item: choose another one.'));
  let steps: readonly (() => Command)[] = [];
  await placeInstance(editor, item.prefab, place, {
    bring: () => bringItem(scene, item),
    follow: (instance) => (steps = id === 'player' ? stepsOfPlayer(scene, instance, editor.viewport.rayCamera) : []),
  });
  if (steps.length > 1) editor.notices.show('info', t('A ground was added, since the player had nothing to stand on.'));
}
