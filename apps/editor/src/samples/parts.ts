import { lightShadows, meshShadows } from '@farol/engine';
import type { FieldValue, Vector3Tuple } from '@farol/engine/fields';
import type { Part, SampleScene, Values } from './SampleScene';

/** A mesh that casts and receives shadows. */
export const mesh = (name: string, values: Values = {}): Part => [
  'ObjectRenderer',
  { mesh: name, ...meshShadows, ...values },
];

/** A light with the default shadow settings of new lights. */
export const light = (type: 'directional' | 'point' | 'spot', values: Values): Part => [
  'Light',
  { type, ...lightShadows[type], ...values },
];

/** Material values for one of the engine's generated textures. */
const textured = (name: string, values: Values): Record<string, FieldValue> => ({
  ...{ map: name, normalMap: `${name}-normal` },
  ...values,
});

export const stone = textured('stone', { colour: [0.9, 0.85, 0.78], roughness: 0.85, repeat: 2 });
export const marble = textured('marble', { colour: [0.86, 0.83, 0.78], roughness: 0.7 });
export const wood = textured('wood', { colour: [0.8, 0.66, 0.5], roughness: 0.75 });
export const iron: Values = { colour: [0.09, 0.09, 0.1], roughness: 0.5, metalness: 0.8 };

/** The scene's camera, moved by keys and dragging. @returns its id */
export function addCamera(
  scene: SampleScene,
  position: Vector3Tuple,
  target: Vector3Tuple,
  values: Values = {},
): string {
  const camera = scene.object(
    'Camera',
    { position, target },
    ['Camera', { near: 0.1, far: 150, ...values }],
    ['KeyController', { speed: 4 }],
    ['MouseController'],
  );
  scene.activeCamera = camera;
  return camera;
}
