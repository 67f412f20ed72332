import { lightShadows, type Scene } from '@farol/engine';
import { SceneBuilder } from '../SceneBuilder';
import type { SceneBuildOptions } from '../SceneDefinition';

/** Options of `niceScene`. */
export interface NiceSceneOptions extends SceneBuildOptions {
  /** Number of moving point lights besides the thesis's three; 0 when absent. */
  lights?: number;
}

/**
 * The thesis's NiceScene (2.2.1.3 and the G-buffer's figure): a dragon between a sphere in the air and a cylinder, in a
 * room of four planes, with all three kinds of lights. The directional light shines down, forward and to the right, so
 * only the red point light reaches the planes behind and on the left; a white spot light draws an arc on the floor.
 * @throws AssetError (as a rejection) when the dragon cannot be loaded from the library's address
 */
export async function niceScene(options: NiceSceneOptions = {}): Promise<Scene> {
  const { lights = 0, shadows = false } = options;
  const build = new SceneBuilder('Nice scene', options);
  await build.scene.assets.prepareMesh('dragon', Math.PI);
  build.camera([0.7, 2.9, 7.6], [-0.1, 1.55, 0], { fov: 0.8, near: 0.1, far: 60 }, 3);

  const half = Math.PI / 2;
  const room = build.group('Room');
  const walls = {
    map: 'stone',
    normalMap: 'stone-normal',
    colour: [0.85, 0.85, 0.85],
    repeat: 2,
    roughness: 0.8,
  } as const;
  const floor = {
    map: 'tiles',
    normalMap: 'tiles-normal',
    colour: [0.85, 0.85, 0.85],
    repeat: 2,
    roughness: 0.45,
  } as const;
  build.mesh('Floor', 'plane', floor, { scale: [9, 1, 8], parent: room });
  build.mesh('Wall behind', 'plane', walls, {
    position: [0, 2.75, -4],
    rotation: [half, 0, 0],
    scale: [9, 1, 5.5],
    parent: room,
  });
  const left = { position: [-4.5, 2.75, 0], rotation: [0, 0, -half], scale: [5.5, 1, 8], parent: room } as const;
  build.mesh('Wall on the left', 'plane', walls, left);
  const right = { position: [4.5, 2.75, 0], rotation: [0, 0, half], scale: [5.5, 1, 8], parent: room } as const;
  build.mesh('Wall on the right', 'plane', walls, right);

  const dragon = { colour: [0.55, 0.66, 0.58], specular: [0.5, 0.5, 0.5], shininess: 60, kind: 'phong' } as const;
  build.mesh(
    'Dragon',
    'dragon',
    { ...dragon, creaseAngle: Math.PI },
    { position: [-0.2, 0, 0.3], rotation: [0, -0.35, 0], scale: [3.6, 3.6, 3.6] },
  );
  const ball = { kind: 'phong', colour: [0.75, 0.75, 0.78], specular: [0.8, 0.8, 0.8], shininess: 90 } as const;
  build.mesh('Sphere', 'sphere', ball, { position: [-2.5, 3.1, -1.4], scale: [1.5, 1.5, 1.5] });
  build.mesh(
    'Cylinder',
    'cylinder',
    { colour: [0.78, 0.7, 0.5], roughness: 0.5 },
    { position: [2.7, 1.1, -1.2], scale: [1.3, 2.2, 1.3] },
  );

  build.light('Ambient light', { type: 'ambient', intensity: 0.16 }, [0, 5, 0]);
  build.light(
    'Directional light',
    { type: 'directional', intensity: 1.3, diffuse: [1, 0.96, 0.88], ...(shadows && { shadowExtent: 8 }) },
    [-6, 6.5, -0.7],
    [0, 0, 0],
  );
  const pointShadow = shadows ? { ...lightShadows.point, castShadow: true } : {};
  const red = { diffuse: [1, 0.09, 0.05], ownSpecular: true, specular: [1, 0.5, 0.45] } as const;
  build.light(
    'Point light',
    { ...red, type: 'point', intensity: 2.4, attenuation: 'near-far', near: 0.5, far: 6.2, ...pointShadow },
    [-2.3, 1.9, 0],
  );
  const spot = { type: 'spot', diffuse: [1, 1, 1], intensity: 110, cutoff: 0.36, exponent: 24, range: 12 } as const;
  build.light('Spot light', spot, [-1.2, 5, 3.6], [1.5, 0, 1.9]);

  build.movingLights(lights, build.group('Lights'), (_, random) => ({
    position: [7.5 * (random() - 0.5), 0.4 + 3.6 * random(), 6.5 * (random() - 0.5)],
    extent: [0.8, 0.4, 0.8],
    speed: 0.4 + 0.6 * random(),
    range: 2.5,
    intensity: 1.2 / Math.max(1, lights / 40),
  }));
  return build.scene;
}
