import { Camera, type GameObject, Light, ModelRenderer, ObjectRenderer, type Scene } from '@farol/engine';
import { Box2, Box3, type Camera as ThreeCamera, Vector2, Vector3 } from 'three';
import { boundsOf } from './boundsOf';

const bounds = new Box3();
const middle = new Vector3();
const point = new Vector2();

/**
 * The GameObjects whose centre is inside a box on screen: active, unlocked meshes, models, lights and cameras, in tree
 * order.
 * @param corners - corners of the box, in normalised device coordinates
 */
export function pickBox(scene: Scene, camera: ThreeCamera, corners: Vector2[]): GameObject[] {
  const box = new Box2().setFromPoints(corners);
  const found: GameObject[] = [];
  scene.traverse((object) => {
    if (!object.activeInHierarchy) return;
    const isShown =
      object.getComponent(ObjectRenderer) ??
      object.getComponent(ModelRenderer) ??
      object.getComponent(Light) ??
      object.getComponent(Camera);
    if (!isShown || object.lockedInHierarchy) return;
    boundsOf([object], bounds, false);
    if (bounds.isEmpty()) return;
    bounds.getCenter(middle).project(camera);
    if (middle.z < -1 || middle.z > 1) return;
    if (box.containsPoint(point.set(middle.x, middle.y))) found.push(object);
  });
  return found;
}
