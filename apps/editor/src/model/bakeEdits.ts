import { type Command, countLabel, SetFields, t } from '@farol/editing';
import { type GameObject, Light, ModelRenderer, ObjectRenderer, type Scene, type TakenAsset } from '@farol/engine';
import { AddAssets, RemoveAsset } from './commands/AddAssets';
import { Sequence } from './commands/Sequence';

/** Components that move nothing. */
const still: ReadonlySet<string> = new Set([
  ...['Transform', 'ObjectRenderer', 'ModelRenderer', 'Light', 'Camera', 'Decal', 'Collider', 'Wall', 'Room'],
  ...['AudioSource', 'AudioListener', 'EventTrigger'],
]);

/** Whether nothing of an object, or above it, may move it. */
function staysInPlace(object: GameObject): boolean {
  for (let each: GameObject | null = object; each; each = each.parent)
    if (each.components.some(({ typeName }) => !still.has(typeName))) return false;
  return true;
}

/** Objects that are drawn, and that nothing moves. */
export function objectsInPlace(scene: Scene): GameObject[] {
  const renderers = [...scene.componentsOf(ObjectRenderer), ...scene.componentsOf(ModelRenderer)];
  const objects = new Set(renderers.filter(({ isActive }) => isActive).map(({ gameObject }) => gameObject));
  return [...objects].filter((object) => !object.isStatic && staysInPlace(object));
}

/** Lights that nothing moves and that are drawn in realtime. */
export const lightsInPlace = (scene: Scene): Light[] =>
  scene
    .componentsOf(Light)
    .filter((light) => light.isActive && light.mode === 'realtime' && staysInPlace(light.gameObject));

/** Has lights baked. */
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

/** Takes out the baked light that is shown, where there is some. */
function removing(scene: Scene): (() => Command)[] {
  const { bakedLight } = scene.settings;
  if (bakedLight === null) return [];
  return [() => showing(scene, null), () => new RemoveAsset(scene.assets, bakedLight)];
}

/** Lights the scene by baked light, in place of what there was. @param baked - out of the library */
export const showBakedLight = (scene: Scene, baked: TakenAsset): Command =>
  new Sequence(t('Baked the light'), [
    ...removing(scene),
    () => new AddAssets(scene.assets, [baked]),
    () => showing(scene, baked.name),
  ]);

/** Lights the scene as before it was baked, and takes the baked light out of the library. */
export const clearBakedLight = (scene: Scene): Command => new Sequence(t('Cleared the baked light'), removing(scene));
