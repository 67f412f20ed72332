import type { Scene } from '@farol/engine';
import '../meshPack';
import { lightBudget } from '../lightBudget';
import { SceneBuilder } from '../SceneBuilder';
import type { SceneBuildOptions } from '../SceneDefinition';
import { addAtrium } from './addAtrium';
import { atriumPlan } from './atriumPlan';

/** Options of `sponza`. */
export interface SponzaOptions extends SceneBuildOptions {
  /** Width of the generated textures (texels): 128, 256 or 512; 256 when absent. */
  textureSize?: 128 | 256 | 512;
  /** Number of moving lights that cast shadows; 0 when absent. */
  shadowLights?: number;
  /** Whether the lights stand still. Default false. */
  still?: boolean;
}

/**
 * An atrium of the scale of the Sponza palace: two storeys of arcades round a nave that is open to the sky, about 100
 * meshes and 260,000 triangles, with moving point lights (thesis 3.2.8 and 4.2.2).
 * @param lights - moving point lights, 0 or more
 */
export async function sponza(lights: number, options: SponzaOptions = {}): Promise<Scene> {
  const build = new SceneBuilder('Sponza', options);
  const { length, outer } = atriumPlan;
  build.scene.settings.backgroundColour = [0.05, 0.075, 0.14];
  build.camera([-17.6, 2.5, 1.6], [4, 4.7, -1.6], { fov: 1.05, near: 0.1, far: 120 });
  build.light(
    'Sun',
    { type: 'directional', diffuse: [1, 0.78, 0.55], intensity: 0.8, ...(options.shadows && { shadowExtent: 24 }) },
    [14, 26, 9],
    [0, 0, 0],
  );
  build.light(
    'Sky',
    { type: 'hemisphere', diffuse: [0.42, 0.5, 0.72], groundColour: [0.24, 0.2, 0.16], intensity: 0.4 },
    [0, 20, 0],
  );
  addAtrium(build, options.textureSize ?? 256);
  const { range, intensity } = lightBudget(lights, { volume: 7000, range: 6, light: 11 });
  build.movingLights(lights, build.group('Lights'), (i, random) => ({
    position: [(length - 5) * (random() - 0.5), 0.8 + 9.5 * random() ** 1.3, (2 * outer - 3) * (random() - 0.5)],
    extent: [1 + 2.5 * random(), 0.3 + 0.6 * random(), 0.8 + 1.5 * random()],
    speed: (options.still ? 0 : 1) * (0.6 + 1.2 * random()),
    range,
    intensity,
    castShadow: i < (options.shadowLights ?? 0),
  }));
  return build.scene;
}
