import { t } from '@farol/editing';
import {
  type AssetLibrary,
  builtinComponents,
  Camera,
  ComponentRegistry,
  createRandom,
  GameObject,
  Light,
  RandomMovement,
  Scene,
} from '@farol/engine';
import type { FieldTable, FieldValue, ValuesOf } from '@farol/engine/fields';
import { Box3, Color, type Material, Mesh, type Object3D, Sphere, Texture, Vector3 } from 'three';
import type { LoadedModel } from './loadModel';
import { ModelAnimation } from './ModelAnimation';

export const modelParameters = {
  lights: {
    kind: 'number',
    default: 24,
    min: 0,
    max: 4096,
    integer: true,
    help: 'Moving point lights in a ring round the model.',
  },
  seed: { kind: 'number', default: 1, min: 0, integer: true, help: 'Another number, other paths of the lights.' },
} as const satisfies FieldTable;

/** Values of all `modelParameters`: the given ones, else the defaults. */
export function modelValues(values: Record<string, FieldValue>): ValuesOf<typeof modelParameters> {
  return Object.fromEntries(
    Object.entries(modelParameters).map(([name, field]) => [name, values[name] ?? field.default]),
  ) as ValuesOf<typeof modelParameters>;
}

/** Components of scenes with a dropped model. */
const registry = new ComponentRegistry([...builtinComponents.types.values(), ModelAnimation]);

/**
 * Makes a scene of a loaded model with its own lights and its first animation, a camera that sees the whole model, a
 * hemisphere light, and a ring of moving point lights around it.
 *
 * The scene does not own the model: `disposeModel` frees it.
 *
 * @throws Error when the model has no visible mesh
 */
export function modelScene(
  { name, gltf }: LoadedModel,
  parameters: { lights: number; seed: number },
  assets: AssetLibrary,
): Scene {
  const bounds = new Box3().setFromObject(gltf.scene, true);
  if (bounds.isEmpty())
    throw new Error(t('{name}: its scene has no mesh, so there is nothing to see: choose another file.', { name }));
  const sphere = bounds.getBoundingSphere(new Sphere());
  sphere.radius = Math.max(sphere.radius, 1e-3);

  const scene = new Scene({ name, assets, registry });
  const model = new GameObject(name);
  model.object3D.add(gltf.scene);
  if (gltf.animations.length > 0) model.addComponent(new ModelAnimation().play(gltf.scene, gltf.animations[0]));
  scene.add(model);
  scene.add(viewpoint(sphere, bounds));
  scene.add(skyLight());
  const ring = new GameObject('Lights');
  for (const light of lightRing(sphere, bounds, parameters)) ring.add(light);
  scene.add(ring);
  return scene;
}

/** Frees the model's GPU resources. */
export function disposeModel(model: Object3D): void {
  model.traverse((object) => {
    if (!(object instanceof Mesh)) return;
    object.geometry.dispose();
    for (const material of [object.material].flat() as Material[]) {
      for (const value of Object.values(material)) if (value instanceof Texture) value.dispose();
      material.dispose();
    }
  });
}

function skyLight(): GameObject {
  const sky = new GameObject('Sky');
  sky.addComponent(Light, {
    type: 'hemisphere',
    diffuse: [0.75, 0.85, 1],
    groundColour: [0.35, 0.3, 0.25],
    intensity: 0.6,
  });
  return sky;
}

/** A camera in front of the model and slightly above it, which sees the model's bounding sphere. */
function viewpoint({ center, radius }: Sphere, bounds: Box3): GameObject {
  const fov = Math.PI / 4;
  const distance = (1.05 * radius) / Math.sin(fov / 2);
  const object = new GameObject('Camera');
  const camera = object.addComponent(Camera, { fov, near: radius / 100, far: distance + radius * 20 });
  const eye = new Vector3(0.45, 0.35, 1).normalize().multiplyScalar(distance).add(center);
  camera.lookAt([eye.x, Math.max(eye.y, bounds.min.y + radius * 0.1), eye.z], center.toArray());
  return object;
}

/** Lights of all hues on a ring around the model; each moves around its own position. */
function lightRing({ center, radius }: Sphere, bounds: Box3, { lights, seed }: { lights: number; seed: number }) {
  const random = createRandom(seed);
  const height = bounds.max.y - bounds.min.y;
  const colour = new Color();
  return Array.from({ length: lights }, (_, index) => {
    const angle = (index / lights) * 2 * Math.PI;
    const distance = radius * (0.8 + 0.5 * random());
    const object = new GameObject(`Light ${index + 1}`);
    object.transform.position = [
      center.x + Math.cos(angle) * distance,
      bounds.min.y + height * (0.1 + 1.1 * random()),
      center.z + Math.sin(angle) * distance,
    ];
    colour.setHSL(index / lights, 0.75, 0.6);
    object.addComponent(Light, {
      type: 'point',
      diffuse: [colour.r, colour.g, colour.b],
      // candela: brightness does not depend on the model's size, and little on the number of lights
      intensity: (6 * radius * radius) / Math.max(lights, 4) ** 0.9,
      range: radius * 2,
    });
    object.addComponent(RandomMovement, {
      seed: seed + index,
      extent: [radius * 0.4, height * 0.2 + radius * 0.02, radius * 0.4],
      speed: radius * 0.4,
    });
    return object;
  });
}
