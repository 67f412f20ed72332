import { t } from '@farol/editing';
import type { Scene } from '@farol/engine';
import { containerContent, createId, type FileComponent, type FileObject, writeContainer } from '@farol/engine/files';
import type { LoadedModel } from '../model/loadModel';

/** Components that a measured scene must not have: user input, and those of the viewer. */
const notMeasured = new Set(['KeyController', 'MouseController', 'ModelAnimation']);

/**
 * Packs the current scene into a `.farol` file: with the camera at its current pose and, for a dropped model, all textures.
 *
 * @param model - the dropped model; null for a scene of the engine
 * @throws Error (as a rejection) when the model cannot be packed
 */
export async function sceneFile(scene: Scene, model: LoadedModel | null): Promise<Uint8Array<ArrayBuffer>> {
  const { file, files } = containerContent(scene);
  const all = new Map(files);
  for (const object of file.objects) object.components = object.components.filter(({ type }) => !notMeasured.has(type));
  putCamera(scene, file.objects);
  if (model) {
    const name = model.name.replace(/\.\w+$/, '.glb');
    const path = `assets/${encodeURIComponent(name)}`;
    file.assets = [...file.assets, { name, type: 'model', file: path }];
    all.set(path, await model.pack());
    const [clip] = model.gltf.animations;
    modelObject(file.objects, model.name).components.push({
      type: 'ModelRenderer',
      version: 1,
      id: createId(),
      values: { model: name, ...(clip ? { animation: clip.name } : {}) },
    });
  }
  return writeContainer({ file, files: all });
}

/** Makes the object for the model: a root with the model's name. */
function modelObject(objects: readonly FileObject[], name: string): FileObject {
  const object = objects.find((each) => each.parent === null && each.name === name);
  if (!object) throw new Error(t('The scene has no object {name}: drop the model once more.', { name }));
  return object;
}

/** Copies the camera's current pose into the file, since flying around changes no saved values. */
function putCamera(scene: Scene, objects: readonly FileObject[]): void {
  const camera = scene.activeCamera?.gameObject;
  const object = objects.find(({ id }) => id === camera?.id);
  const transform: FileComponent | undefined = object?.components.find(({ type }) => type === 'Transform');
  if (!camera || !transform) return;
  for (const name of ['position', 'rotation']) transform.values[name] = camera.transform.get(name);
}
