import type { Vector3Tuple } from '@farol/engine/fields';
import { readSceneFile } from '@farol/engine/files';
import { addClip, eased, track, turn } from './clips';
import { addCamera, light, mesh } from './parts';
import { type Place, type ReadPublic, SampleScene, type Values } from './SampleScene';

/** Half the width and depth of the room (m); HEIGHT is its height (m). */
const HALF = 2;
const HEIGHT = 3;
/** Asset name of the baked light. */
export const BAKED = 'Baked light.bake';

const paint = (colour: Vector3Tuple, more: Values = {}): Values => ({ colour, roughness: 0.9, ...more });
const white = paint([0.76, 0.75, 0.71]);

function addRoom(scene: SampleScene): void {
  // planes face +Y
  const wall = (name: string, place: Place, values: Values): void => {
    scene.object(name, { ...place, static: true }, mesh('plane', values));
  };
  const wide = 2 * HALF;
  const middle = HEIGHT / 2;
  const turned = Math.PI / 2;
  wall('Floor', { scale: [wide, 1, wide] }, white);
  wall('Ceiling', { position: [0, HEIGHT, 0], rotation: [Math.PI, 0, 0], scale: [wide, 1, wide] }, white);
  wall('Back wall', { position: [0, middle, -HALF], rotation: [turned, 0, 0], scale: [wide, 1, HEIGHT] }, white);
  const red = paint([0.63, 0.06, 0.05]);
  wall('Red wall', { position: [-HALF, middle, 0], rotation: [0, 0, -turned], scale: [HEIGHT, 1, wide] }, red);
  const green = paint([0.12, 0.45, 0.09]);
  wall('Green wall', { position: [HALF, middle, 0], rotation: [0, 0, turned], scale: [HEIGHT, 1, wide] }, green);
  const glow = { emissive: [1, 0.86, 0.68], emissiveIntensity: 9, castShadow: false } as const;
  const panel = { position: [0, HEIGHT - 0.02, -0.2], rotation: [Math.PI, 0, 0], scale: [1.2, 1, 0.9] } as const;
  wall('Ceiling panel', panel, paint([0.8, 0.8, 0.8], glow));
  scene.object(
    'Tall block',
    { position: [-0.75, 0.85, -0.85], rotation: [0, 0.32, 0], scale: [1, 1.7, 1], static: true },
    mesh('box', white),
  );
  scene.object(
    'Low block',
    { position: [0.8, 0.4, 0.25], rotation: [0, -0.3, 0], scale: [0.9, 0.8, 0.9], static: true },
    mesh('box', white),
  );
  scene.object(
    'Lamp behind the block',
    { position: [-1.5, 0.35, -1.55], static: true },
    light('point', { mode: 'baked', diffuse: [1, 0.45, 0.12], intensity: 2.2, range: 0, bakedRadius: 0.08 }),
  );
}

/** A ball and a knot that move round the room, without lights of their own. */
function addMoving(scene: SampleScene): void {
  const way = addClip(scene, 'Round the room', 12, [
    track(
      '',
      'Transform.position',
      eased(
        [0, [-1.5, 0.35, 0.9]],
        [3, [1.5, 1.3, 0.9]],
        [6, [1.45, 1.9, -1.3]],
        [9, [-1.3, 2.2, -0.3]],
        [12, [-1.5, 0.35, 0.9]],
      ),
    ),
  ]);
  const ball = scene.object('Ball', { position: [-1.5, 0.35, 0.9] }, ['Animation', { clip: way }]);
  scene.object('White', { scale: [0.6, 0.6, 0.6], parent: ball }, mesh('sphere', paint([0.85, 0.85, 0.85])));
  const spin = addClip(scene, 'Turns', 8, [track('', 'Transform.rotation', turn(8))]);
  const stand = scene.object('On the low block', { position: [0.8, 1.12, 0.25] }, ['Animation', { clip: spin }]);
  scene.object(
    'Cube',
    { rotation: [0.6, 0.4, 0.2], scale: [0.36, 0.36, 0.36], parent: stand },
    mesh('box', paint([0.85, 0.85, 0.85])),
  );
  for (const [i, colour] of (
    [
      [0.25, 0.5, 1],
      [1, 0.3, 0.8],
    ] as const
  ).entries()) {
    const place = { position: [i === 0 ? -0.3 : 0.5, 0.9 + 0.6 * i, 0.8 - 1.2 * i] } as const;
    const fly = scene.object(`Firefly ${i + 1}`, place, [
      'RandomMovement',
      { seed: 3 + i, extent: [1.1, 0.5, 0.8], speed: 0.7 },
    ]);
    scene.object(
      'Light',
      { parent: fly },
      light('point', { diffuse: colour, intensity: 0.25, range: 1.6, castShadow: true, shadowMapSize: 256 }),
    );
    scene.object('Glow', { scale: [0.05, 0.05, 0.05], parent: fly }, [
      'ObjectRenderer',
      { mesh: 'sphere', colour, emissive: colour, emissiveIntensity: 3 },
    ]);
  }
}

/**
 * Baked light that bakeSample.mjs has just written, else the one in the sample's present file; null when there is
 * neither.
 */
async function bakedLight(readPublic: ReadPublic): Promise<Uint8Array<ArrayBuffer> | null> {
  const fresh = await readPublic('scenes/baked-room.bake').catch(() => null);
  if (fresh) return fresh;
  const kept = await readPublic('scenes/baked-room.farol').catch(() => null);
  const blob = kept && (await readSceneFile(kept)).fileOf(`assets/${encodeURIComponent(BAKED)}`);
  return blob && new Uint8Array(await blob.arrayBuffer());
}

/**
 * A room with baked light, after the Cornell box: a glowing panel, a lamp, coloured walls, and moving objects. Baking
 * needs a GPU: `packages/tools/bakeSample.mjs` does it in a browser, and its result is kept here.
 */
export async function bakedRoom(readPublic: ReadPublic): Promise<SampleScene> {
  const scene = new SampleScene('Baked room');
  Object.assign(scene.settings, {
    ...{ backgroundColour: [0.004, 0.005, 0.008], toneMapping: 'agx', exposure: 1.35, antialiasing: 'auto' },
    ...{ bakeSize: '512', bakeSamples: 512, bakeBounces: 4, bakeSky: false, bakeProbeSpacing: 0.5 },
  });
  addCamera(scene, [0, 1.5, 6.1], [0, 1.45, 0], { fov: 0.72 });
  addRoom(scene);
  addMoving(scene);
  const bytes = await bakedLight(readPublic);
  if (bytes) scene.settings.bakedLight = scene.file('bake', BAKED, bytes);
  return scene;
}
