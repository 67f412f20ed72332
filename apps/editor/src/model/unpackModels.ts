import { type Command, countLabel, t, tCount } from '@farol/editing';
import {
  Animation,
  type AssetLibrary,
  type GameObject,
  isUnpackable,
  keptTogether,
  type ModelRenderer,
  objectOfPart,
  objectsOfModel,
  type Scene,
  subtreeOf,
  type TakenAsset,
  type UnpackOptions,
} from '@farol/engine';
import { surfaceValueFields } from '@farol/engine/fields';
import { endingOf, splitName } from './assetNames';
import { AddAssets } from './commands/AddAssets';
import { PlaceComponents } from './commands/PlaceComponents';
import { PlaceObjects } from './commands/PlaceObjects';
import { Sequence } from './commands/Sequence';

const inWords = (found: string): string =>
  ({
    'a skeleton': t('a skeleton'),
    'morph targets': t('morph targets'),
    'instances of a mesh': t('instances of a mesh'),
    'points or lines': t('points or lines'),
  })[found] ?? found;

/**
 * Why a model must stay one object; null when it can be unpacked.
 * @param parts - paths of the nodes that a ModelRenderer draws, with semicolons between; '' for the whole model
 * @throws AssetError when the model is not loaded
 */
export function whyNotUnpack(assets: AssetLibrary, name: string, parts = ''): string | null {
  const model = assets.model(name);
  const kept = keptTogether(model);
  const [first] = subtreeOf(model.scene, parts)?.nodes ?? [];
  const part = kept.find(({ nodes }) => nodes.includes(first)) ?? kept[0];
  if (parts === '' && isUnpackable(model, kept)) return null;
  if (parts !== '') name = `${name} (${parts})`;
  const what = part ? inWords(part.reason) : t('parts of a model');
  return t('{name} stays one object: it has {what}, which only a whole model keeps.', { name, what });
}

/** A sentence with the names of parts of unpacked models that a ModelRenderer still draws; null for none. */
export function whatStaysLinked(assets: AssetLibrary, names: readonly string[]): string | null {
  const kept = [...new Set(names)].flatMap((name) => keptTogether(assets.model(name)));
  if (kept.length === 0) return null;
  const what = [...new Set(kept.map(({ reason }) => inWords(reason)))].join(', ');
  const objects = kept.slice(0, 5).map(({ nodes }) => `“${objectOfPart(nodes)}”`);
  if (kept.length > 5) objects.push('…');
  return tCount(
    kept.length,
    '{objects} stays linked to the model, as one object with its clips: it has {what}.',
    '{objects} stay linked to the model, each as one object with its clips: they have {what}.',
    { objects: objects.join(', '), what },
  );
}

/** Folder for the materials of a model: 'Props/robot/' for 'Props/robot.glb'. */
function materialFolder(name: string): string {
  const { folder, leaf } = splitName(name);
  const stem = leaf.slice(0, leaf.length - endingOf(leaf).length) || leaf;
  return folder === '' ? `${stem}/` : `${folder}/${stem}/`;
}

/**
 * Replaces each whole model by a tree of objects below its object: meshes, lights, cameras, materials as assets, and an
 * Animation when it has clips. Parts joined by a skeleton or morph targets become one object with a ModelRenderer. The
 * objects of the ModelRenderers keep their poses and other components.
 * @param renderers - with models that are loaded
 * @throws Error when one cannot be unpacked; see `whyNotUnpack`
 */
export function unpackModels(scene: Scene, renderers: readonly ModelRenderer[]): Command {
  const named = renderers.filter(({ model }) => model !== null);
  for (const { model, parts } of named) {
    const problem = whyNotUnpack(scene.assets, model!, parts);
    if (problem !== null) throw new Error(problem);
  }
  const objects = named.map(({ gameObject }) => gameObject);
  const ids = objects.map(({ id }) => id);
  return new Sequence(
    countLabel(t('Unpacked'), objects),
    named.map((renderer) => () => unpackOne(scene, renderer)),
    { done: ids, undone: ids },
  );
}

function unpackOne(scene: Scene, renderer: ModelRenderer): Command {
  const { assets } = scene;
  const { gameObject: parent, castShadow, receiveShadow } = renderer;
  const name = renderer.model!;
  const model = assets.model(name);
  const wears = surfaceOf(renderer);
  const options = { materialFolder: materialFolder(name), castShadow, receiveShadow, wears };
  const { objects, materials } = objectsOfModel(model, assets, name, options);
  const taken = materials.map((each): TakenAsset => {
    assets.addMaterial(each.name, each.values);
    return assets.take(each.name);
  });
  if (!renderer.enabled) for (const object of objects) object.active = false;
  const index = parent.components.indexOf(renderer);
  const first = parent.children.length;
  const placements = objects.map((object, i) => ({ object, parent, index: first + i }));
  const stay = { done: [parent.id], undone: [parent.id] };
  return new Sequence(
    t('Unpack'),
    [
      () => new AddAssets(assets, taken),
      () => new PlaceComponents('', scene, 'remove', [{ component: renderer, object: parent, index }]),
      ...(model.animations.length > 0 && !parent.getComponent(Animation)
        ? [() => addAnimation(scene, renderer, parent)]
        : []),
      () => new PlaceObjects('', scene, 'add', placements, stay),
    ],
    stay,
  );
}

/** Surface and its values that the unpacked parts get. */
function surfaceOf(renderer: ModelRenderer): UnpackOptions['wears'] {
  if (renderer.surface === null) return undefined;
  const names = ['surface', ...Object.keys(surfaceValueFields)];
  return {
    material: renderer.surfaceMaterial,
    values: Object.fromEntries(names.map((name) => [name, renderer.getAuthored(name)])),
  };
}

function addAnimation(scene: Scene, renderer: ModelRenderer, object: GameObject): Command {
  const { assets } = scene;
  const { animation, animationSpeed, enabled } = renderer;
  const clip = assets.model(renderer.model!).clips.find(({ name }) => name === animation);
  const added = new Animation();
  added.set('clip', clip ? assets.nameOf(clip) : null);
  added.set('speed', animationSpeed);
  added.enabled = enabled;
  return new PlaceComponents('', scene, 'add', [{ component: added, object, index: object.components.length }]);
}
