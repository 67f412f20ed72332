import { Vector3 } from 'three';
import type { Scene } from '@farol/engine';
import '../meshPack';
import { SceneBuilder } from '../SceneBuilder';
import type { BenchmarkOptions } from './benchmarkLights';
import { registerSceneAssets } from '../registerSceneAssets';
import { hueColour } from '../hueColour';
import { addLightGrid } from './addLightGrid';

/** Distance between the centres of two objects (m). */
const SPACING = 1.8;

/**
 * `n` × `nRows` meshes of size 1 on a floor, and `m` × `mRows` moving point lights above them (thesis 3.2.8).
 * @param n - meshes from left to right, 1 or more
 * @param m - lights from left to right, 0 or more
 * @param mesh - name of a mesh of the library or of a demo scene, such as 'temple/column'; loaded if necessary
 * @throws AssetError (as a rejection) when there is no such mesh
 */
export async function benchmarkLightsObjects(
  n: number,
  m: number,
  mesh = 'sphere',
  options: BenchmarkOptions = {},
): Promise<Scene> {
  const { nRows = n } = options;
  const build = new SceneBuilder('Benchmark: lights and objects', options);
  build.scene.settings.backgroundColour = [0.004, 0.005, 0.008];
  const { assets } = build.scene;
  registerSceneAssets(assets);
  await assets.prepareMesh(mesh, Math.PI);
  const geometry = assets.mesh(mesh, Math.PI);
  geometry.computeBoundingBox();
  const box = geometry.boundingBox!;
  const size = Math.max(...box.getSize(new Vector3()).toArray(), 1e-6);
  const side = Math.max(n, nRows) * SPACING + 2;
  build.camera(
    [side * 0.18, 1.5 + side * 0.42, side * 0.78],
    [0, 0.2, side * 0.03],
    { fov: 0.8, near: 0.2, far: 300 },
    6,
  );
  build.light('Ambient light', { type: 'ambient', intensity: 0.1 }, [0, 5, 0]);
  build.mesh('Floor', 'plane', { colour: [0.5, 0.5, 0.5], roughness: 0.7 }, { scale: [side, 1, side] });
  const objects = build.group('Objects');
  for (let j = 0; j < nRows; j++) {
    for (let i = 0; i < n; i++) {
      const position = [(i + 0.5 - n / 2) * SPACING, -box.min.y / size, (j + 0.5 - nRows / 2) * SPACING] as const;
      const colour = hueColour((i + j) / 7, 0.25);
      const scale = [1 / size, 1 / size, 1 / size] as const;
      build.mesh(
        'Object',
        mesh,
        { colour: [colour[0] * 0.75, colour[1] * 0.75, colour[2] * 0.75], roughness: 0.45, creaseAngle: Math.PI },
        { position, scale, parent: objects },
      );
    }
  }
  addLightGrid(build, { count: m, rows: options.mRows, side, floor: 0.75, shadows: options.shadows });
  return build.scene;
}
