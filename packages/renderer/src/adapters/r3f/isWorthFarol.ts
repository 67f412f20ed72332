import type { ArrayCamera, Camera, Mesh, Object3D, OrthographicCamera, PerspectiveCamera, Scene } from 'three';
import { isLit } from '../../materials/isLit';
import type { FarolView } from '../../renderer/SceneView';

/** Maximum number of objects tested; a scene with more counts as lit. */
const LOOKS = 64;

let visits = 0;

/**
 * Whether Farol should draw a scene. Scenes without lit materials, such as full-screen triangles of post-processing and pictures
 * of depth or normals, look the same by three, with less work.
 * @param effects - whether there are effects, which also show without lit materials
 */
export function isWorthFarol(scene: Object3D, camera: Camera, effects: boolean): boolean {
  const { isPerspectiveCamera } = camera as PerspectiveCamera;
  const { isOrthographicCamera } = camera as OrthographicCamera;
  if (!isPerspectiveCamera && !isOrthographicCamera && !(camera as ArrayCamera).isArrayCamera) return false;
  if ((scene as FarolView).isFarolView) return false; // another FarolRenderer draws this scene
  const { overrideMaterial = null } = scene as Scene;
  if (overrideMaterial !== null) return isLit(overrideMaterial);
  visits = LOOKS;
  // a full-screen triangle is the only object of its scene
  return hasLit(scene) || (effects && LOOKS - visits > 2);
}

/** Whether an object or a descendant is lit, or there are more than LOOKS objects. */
function hasLit(object: Object3D): boolean {
  if (--visits < 0) return true;
  const { material } = object as Partial<Mesh>;
  if (material !== undefined && (Array.isArray(material) ? material.some((one) => one && isLit(one)) : isLit(material)))
    return true;
  const { children } = object;
  for (let i = 0; i < children.length; i++) if (hasLit(children[i])) return true;
  return false;
}
