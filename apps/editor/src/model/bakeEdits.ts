import { type Command, countLabel, SetFields, t } from '@farol/editing';
import { type GameObject, Light, ModelRenderer, ObjectRenderer, type Scene, type TakenAsset } from '@farol/engine';
import { bakeSources } from '@farol/engine/bake';
import { AddAssets, RemoveAsset } from './commands/AddAssets';
import { Sequence } from './commands/Sequence';

/** Component types that never move their object. */
const still: ReadonlySet<string> = new Set([
  ...['Transform', 'ObjectRenderer', 'ModelRenderer', 'Light', 'Camera', 'Decal', 'Collider', 'Wall', 'Room'],
  ...['AudioSource', 'AudioListener', 'EventTrigger'],
]);

/** Whether no component of an object or of its ancestors may move it. */
function staysInPlace(object: GameObject): boolean {
  for (let each: GameObject | null = object; each; each = each.parent)
    if (each.components.some(({ typeName }) => !still.has(typeName))) return false;
  return true;
}

/** Rendered objects that no component moves. */
export function objectsInPlace(scene: Scene): GameObject[] {
  const renderers = [...scene.componentsOf(ObjectRenderer), ...scene.componentsOf(ModelRenderer)];
  const objects = new Set(renderers.filter(({ isActive }) => isActive).map(({ gameObject }) => gameObject));
  return [...objects].filter((object) => !object.isStatic && staysInPlace(object));
}

/** Realtime lights that no component moves. */
export const lightsInPlace = (scene: Scene): Light[] =>
  scene
    .componentsOf(Light)
    .filter((light) => light.isActive && light.mode === 'realtime' && staysInPlace(light.gameObject));

/** Numbers of static objects, baked lights, instanced objects; objects and lights to add where there are none. */
export function countForBake(scene: Scene): readonly [number, number, number, number, number] {
  const { objects, lights, instanced } = bakeSources(scene);
  return [
    objects.length,
    lights.length,
    instanced.length,
    objects.length === 0 ? objectsInPlace(scene).length : 0,
    lights.length === 0 ? lightsInPlace(scene).length : 0,
  ];
}

export const bakeLights = (lights: readonly Light[]): Command =>
  new SetFields(
    countLabel(
      t('Made baked:'),
      lights.map(({ gameObject }) => gameObject),
    ),
    lights.map((owner) => ({ owner, name: 'mode', value: 'baked' })),
  );

const showing = (scene: Scene, name: string | null): Command =>
  new SetFields('Show baked light', [{ owner: scene.settings, name: 'bakedLight', value: name }]);

function removing(scene: Scene): (() => Command)[] {
  const { bakedLight } = scene.settings;
  if (bakedLight === null) return [];
  return [() => showing(scene, null), () => new RemoveAsset(scene.assets, bakedLight)];
}

/** Uses new baked light, in place of the old. @param baked - not in the library yet */
export const showBakedLight = (scene: Scene, baked: TakenAsset): Command =>
  new Sequence(t('Baked the light'), [
    ...removing(scene),
    () => new AddAssets(scene.assets, [baked]),
    () => showing(scene, baked.name),
  ]);

/** Lights the scene in realtime again, and removes the baked light from the library. */
export const clearBakedLight = (scene: Scene): Command => new Sequence(t('Cleared the baked light'), removing(scene));
