import type { Scene } from '@farol/engine';
import { lightBudget } from '../lightBudget';
import { SceneBuilder } from '../SceneBuilder';
import type { SceneBuildOptions } from '../SceneDefinition';

/** Options of `dragons`. */
export interface DragonsOptions extends SceneBuildOptions {
  /** Number of moving point lights; 24 when absent. */
  lights?: number;
}

/**
 * Four dragons on a floor, lit by coloured point lights (thesis 4.1).
 * @throws AssetError (as a rejection) when the dragon cannot be loaded from the library's address
 */
export async function dragons(options: DragonsOptions = {}): Promise<Scene> {
  const { lights = 24 } = options;
  const build = new SceneBuilder('Dragons', options);
  build.scene.settings.backgroundColour = [0.004, 0.005, 0.008];
  await build.scene.assets.prepareMesh('dragon', Math.PI);
  build.camera([0.6, 3.9, 8.6], [0, 0.9, 0.2], { fov: 0.8, near: 0.1, far: 80 });
  build.light(
    'Sky',
    { type: 'hemisphere', diffuse: [0.4, 0.45, 0.6], groundColour: [0.12, 0.1, 0.1], intensity: 0.25 },
    [0, 8, 0],
  );
  build.mesh(
    'Floor',
    'plane',
    { map: 'tiles', normalMap: 'tiles-normal', colour: [0.7, 0.7, 0.72], repeat: 8, roughness: 0.35 },
    { scale: [30, 1, 30] },
  );
  const looks = [
    { colour: [0.75, 0.75, 0.75], roughness: 0.35, metalness: 0 },
    { colour: [0.9, 0.62, 0.3], roughness: 0.38, metalness: 0.9 },
    { colour: [0.42, 0.62, 0.5], roughness: 0.25, metalness: 0 },
    { colour: [0.72, 0.42, 0.36], roughness: 0.6, metalness: 0 },
  ] as const;
  const flock = build.group('Dragons');
  looks.forEach((look, i) => {
    const position = [i % 2 === 0 ? -2.1 : 2.1, 0, i < 2 ? 1.5 : -2.1] as const;
    const rotation = [0, (i % 2 === 0 ? 0.35 : -0.35) + (i % 2) * Math.PI, 0] as const;
    const scale = [3.4, 3.4, 3.4] as const;
    build.mesh('Dragon', 'dragon', { ...look, creaseAngle: Math.PI }, { position, rotation, scale, parent: flock });
  });
  const { range, intensity } = lightBudget(lights, { volume: 420, range: 4.5, light: 7 });
  build.movingLights(lights, build.group('Lights'), (i, random) => ({
    position: [9 * (random() - 0.5), 0.4 + 2.6 * random(), 8 * (random() - 0.5)],
    extent: [0.6 + 1.4 * random(), 0.3, 0.6 + 1.4 * random()],
    speed: 0.4 + 0.8 * random(),
    range,
    intensity,
    castShadow: options.shadows === true && i < 3,
  }));
  return build.scene;
}
