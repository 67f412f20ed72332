import type { Command } from '@farol/editing';
import { Camera } from '@farol/engine';
import { Quaternion, Vector3 } from 'three';
import { addCameraAt, alignCamera, poseProblem } from '../cameraEdits';
import { setView } from '../commands/SetValue';
import type { EditorDocument } from '../EditorDocument';
import { below, type Random } from './random';

/** Stores or removes a view, or moves a camera to a view. */
export function randomViewCommand(random: Random, { scene, selection }: EditorDocument): Command {
  const number = (): number => random() * 20 - 10;
  const position = [number(), number(), number()] as const;
  const target = [number(), number(), 20] as const;
  const orthographic = random() < 0.5;
  if (random() < 0.4) {
    const view = { name: `View ${below(random, 9)}`, position, target, fov: 0.1 + random(), orthographic };
    return setView('Keep view', scene, 1 + below(random, 9), random() < 0.4 ? null : view);
  }
  const view = {
    position: new Vector3(...position),
    quaternion: new Quaternion(number(), number(), number(), 1).normalize(),
    fov: 0.1 + random(),
    size: orthographic ? 1 + random() : null,
    far: 100 * random(),
  };
  const cameras = scene.componentsOf(Camera);
  const camera = cameras.length > 0 ? cameras[below(random, cameras.length)] : null;
  if (camera && poseProblem(camera) === null) return alignCamera(camera, view);
  return addCameraAt(scene, 'Camera', view, selection.ids);
}
