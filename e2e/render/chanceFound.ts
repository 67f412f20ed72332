import type { SceneFacts } from '../pages/chance/SceneFacts';

/** Scenes by chance that were off, cut down: each by the fault that it showed. A new one is an entry. */
export const chanceFound: Readonly<Record<string, SceneFacts>> = {
  'a light field by two cameras, each in its part of the target': {
    view: { camera: 'two' },
    lights: [{ kind: 'field', position: [0, 0, 3] }],
    things: [{}],
  },
  'a line lit by the material of the scene, whose segments meet in a pixel': {
    world: { override: {} },
    lights: [{ position: [1.5, 2, 2] }, { position: [-2, 1, 3] }],
    things: [{ as: 'line', shape: 'box', position: [1.3, 0.57, -0.85] }],
  },
  'levels of detail, chosen by the place of an array of cameras': {
    view: { camera: 'array', position: [-2.1, 1.6, 5.6] },
    lights: [{ kind: 'ambient' }],
    things: [{ as: 'levels' }],
  },
  'an array of cameras over the canvas, whose viewports have fractions': {
    view: { camera: 'array', target: 'canvas' },
    lights: [{ position: [1, 2, 3], intensity: 20 }],
    things: [{ position: [-2, 0, 0], shape: 'box' }, {}],
  },
  'an image thrown at alphaHash, whose holes leave no neighbours in a G-buffer': {
    view: { position: [1.3, 2.5, 6.4] },
    lights: [{ kind: 'spot', map: 'checker', position: [1, 2.5, 3] }],
    things: [
      { position: [0, -1.3, 0], rotation: [-1.5708, 0, 0], scale: [40, 40, 1] },
      { material: { alphaHash: true, opacity: 0.5 } },
    ],
  },
  'a group without a material, of a mesh that casts a shadow': {
    lights: [{ kind: 'spot', shadow: {}, position: [1, 3, 2], intensity: 20 }],
    things: [
      { position: [0, -1.3, 0], rotation: [-1.5708, 0, 0], scale: [12, 12, 1], receiveShadow: true },
      { as: 'of materials', castShadow: true },
    ],
  },
  'a bias along the normals of vertices where a map changes normals, and on back faces': {
    lights: [{ kind: 'point', shadow: { normalBias: 0.1 }, position: [-1, 2, 1.5], intensity: 20 }],
    things: [
      {
        shape: 'bowl',
        material: { type: 'MeshLambertMaterial', normalMap: 'normal', side: 2 },
        castShadow: true,
        receiveShadow: true,
        rotation: [1.2, -1.9, 0.7],
      },
      {
        shape: 'sheet',
        material: { type: 'MeshPhongMaterial', side: 2 },
        castShadow: true,
        receiveShadow: true,
        position: [1.5, 0, 0],
        rotation: [0.4, 2.6, 0],
      },
    ],
  },
};
