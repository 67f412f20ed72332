import { createRandom, GameObject, Light, type Scene } from '@farol/engine';
import { Box3, Color, Vector3 } from 'three';

const NAME = 'Rectangle lights';
/** Range of a rectangle's light (m). */
const RANGE = 1.5;

/**
 * Fills a scene with rectangle lights that shine down and sideways, or removes them; the same in every run.
 * @param count - number of lights; 0 for none
 */
export function setDemoRectangles(scene: Scene, count: number): void {
  const present = scene.roots.find(({ name }) => name === NAME);
  if ((present?.children.length ?? 0) === count) return;
  present?.dispose();
  if (count === 0) return;
  scene.three.updateMatrixWorld(true);
  const bounds = new Box3().setFromObject(scene.three);
  if (!bounds.isEmpty()) scene.add(demoRectangles(bounds, count));
}

function demoRectangles(bounds: Box3, count: number): GameObject {
  const random = createRandom(11);
  const group = new GameObject(NAME);
  const size = bounds.getSize(new Vector3());
  const { x, z } = bounds.getCenter(new Vector3());
  const height = Math.min(size.y, 8);
  const colour = new Color();
  for (let i = 0; i < count; i++) {
    const object = new GameObject(`Rectangle ${i + 1}`);
    object.transform.position = [
      x + size.x * 0.8 * (random() - 0.5),
      bounds.min.y + height * (0.05 + 0.6 * random()),
      z + size.z * 0.8 * (random() - 0.5),
    ];
    object.transform.rotation = [random() - 0.5 - Math.PI / 2, random() - 0.5, random() * Math.PI];
    colour.setHSL(random(), 0.7, 0.6);
    object.addComponent(Light, {
      ...{ type: 'rectangle', diffuse: [colour.r, colour.g, colour.b], intensity: 6 },
      ...{ width: 0.1 + 0.4 * random(), height: 0.1 + 0.2 * random(), areaRange: RANGE },
    });
    group.add(object);
  }
  return group;
}
