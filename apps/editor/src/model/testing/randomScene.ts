import { builtinComponents, GameObject, Scene } from '@farol/engine';
import type { EditorDocument } from '../EditorDocument';
import { objectsOf, pick, type Random } from './random';

/** A scene with one object for each type of component, some nested. */
export function randomScene(random: Random, { assets }: EditorDocument): Scene {
  const scene = new Scene({ name: 'Start', assets });
  for (const type of [...builtinComponents.types.values()].slice(1)) {
    const object = new GameObject(type.typeName);
    object.addComponent(type);
    object.transform.position = [random() * 4, random(), random() * 4];
    object.transform.rotation = [0, random() * 6, 0];
    (random() < 0.5 ? scene : pick(random, [scene, ...objectsOf(scene)])).add(object);
  }
  return scene;
}
