import { createRandom, Decal, GameObject, type Scene } from '@farol/engine';
import { Box3, Color } from 'three';

const NAME = 'Decals';
const COUNT = 40;

/** Adds decals of many colours to a scene, projected from above, or removes them; the same in every run. */
export function setDemoDecals(scene: Scene, shown: boolean): void {
  const present = scene.roots.find(({ name }) => name === NAME);
  if (shown === (present !== undefined)) return;
  if (present) {
    present.dispose();
    return;
  }
  scene.three.updateMatrixWorld(true);
  const bounds = new Box3().setFromObject(scene.three);
  if (!bounds.isEmpty()) scene.add(demoDecals(bounds));
}

function demoDecals(bounds: Box3): GameObject {
  const random = createRandom(7);
  const group = new GameObject(NAME);
  const [width, height, depth] = bounds.max.clone().sub(bounds.min).toArray();
  const side = Math.max(width, depth) * 0.03;
  const colour = new Color();
  for (let i = 0; i < COUNT; i++) {
    const object = new GameObject(`Decal ${i + 1}`);
    object.transform.position = [
      bounds.min.x + width * (0.3 + 0.4 * random()),
      bounds.min.y + height / 2,
      bounds.min.z + depth * (0.3 + 0.4 * random()),
    ];
    object.transform.rotation = [-Math.PI / 2, 0, random() * Math.PI];
    colour.setHSL(i / COUNT, 0.8, 0.5);
    object.addComponent(Decal, {
      size: [side, side, Math.max(height * 1.01, 0.01)],
      colour: [colour.r, colour.g, colour.b],
      opacity: 0.85,
      roughness: 0.3,
      maximumAngle: Math.PI / 3,
      order: i,
    });
    group.add(object);
  }
  return group;
}
