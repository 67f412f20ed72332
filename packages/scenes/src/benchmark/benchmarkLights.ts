import type { Scene } from '@farol/engine';
import { SceneBuilder } from '../SceneBuilder';
import type { SceneBuildOptions } from '../SceneDefinition';
import { addLightGrid } from './addLightGrid';

/** Side of the floor in metres. */
const SIDE = 30;

/** Options of `benchmarkLights` and `benchmarkLightsObjects`. */
export interface BenchmarkOptions extends SceneBuildOptions {
  /** Number of planes or meshes from front to back. Default `n`. */
  nRows?: number;
  /** Number of lights from front to back. Default `m`. */
  mRows?: number;
}

/**
 * `n` × `nRows` planes that make a floor of 30 m × 30 m, and `m` × `mRows` moving point lights just above it (thesis 3.2.8
 * and 4.2.2).
 * @param n - planes from left to right, 1 or more
 * @param m - lights from left to right, 0 or more
 */
export async function benchmarkLights(n: number, m: number, options: BenchmarkOptions = {}): Promise<Scene> {
  const { nRows = n } = options;
  const build = new SceneBuilder('Benchmark: lights', options);
  build.scene.settings.backgroundColour = [0.004, 0.005, 0.008];
  build.camera([0, 22, 25], [0, 0, 1.5], { fov: 0.87, near: 0.5, far: 120 }, 10);
  build.light('Ambient light', { type: 'ambient', intensity: 0.12 }, [0, 5, 0]);
  const planes = build.group('Planes');
  const [across, along] = [SIDE / n, SIDE / nRows];
  for (let j = 0; j < nRows; j++) {
    for (let i = 0; i < n; i++) {
      const position = [(i + 0.5) * across - SIDE / 2, 0, (j + 0.5) * along - SIDE / 2] as const;
      const scale = [across, 1, along] as const;
      build.mesh('Plane', 'plane', { colour: [0.8, 0.8, 0.8], roughness: 0.6 }, { position, scale, parent: planes });
    }
  }
  addLightGrid(build, { count: m, rows: options.mRows, side: SIDE, floor: 0, shadows: options.shadows });
  return build.scene;
}
