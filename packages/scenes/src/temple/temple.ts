import type { Vector3Tuple } from '@farol/editing/fields';
import type { GameObject, Scene } from '@farol/engine';
import '../meshPack';
import { SceneBuilder } from '../SceneBuilder';
import type { SceneBuildOptions } from '../SceneDefinition';
import { lightBudget } from '../lightBudget';
import { registerMeshes } from '../registerMeshes';
import { templeMeshes } from './templeMeshes';
import { templePlan, templeSize } from './templePlan';

const stone = { map: 'marble', normalMap: 'marble-normal', colour: [0.86, 0.83, 0.78], roughness: 0.7 } as const;

function addTemple(build: SceneBuilder): GameObject {
  const building = build.group('Temple');
  const { columnsAcross, columnsAlong, spacing, columnHeight } = templePlan;
  const { halfWidth, halfLength, floor } = templeSize;
  const top = floor + columnHeight;
  const cornice = templePlan.architraveHeight + templePlan.friezeHeight + templePlan.corniceHeight;
  build.mesh(
    'Steps',
    'temple/steps',
    { ...stone, repeat: 0.5, castShadow: true, receiveShadow: true },
    { parent: building },
  );
  const columns = build.group('Columns', building);
  for (let i = 0; i < columnsAcross; i++) {
    for (let j = 0; j < columnsAlong; j++) {
      if (i > 0 && i < columnsAcross - 1 && j > 0 && j < columnsAlong - 1) continue;
      const position = [i * spacing - halfWidth, floor, j * spacing - halfLength] as const;
      build.mesh('Column', 'temple/column', { ...stone, repeat: 0.5 }, { position, parent: columns });
    }
  }
  build.mesh(
    'Entablature',
    'temple/entablature',
    { ...stone, repeat: 0.5 },
    { position: [0, top, 0], parent: building },
  );
  build.mesh(
    'Roof',
    'temple/roof',
    { ...stone, colour: [0.78, 0.5, 0.38], repeat: 0.5 },
    { position: [0, top + cornice, 0], parent: building },
  );
  const wall = {
    map: 'stone',
    normalMap: 'stone-normal',
    colour: [0.9, 0.82, 0.7],
    roughness: 0.85,
    repeat: 0.25,
  } as const;
  build.mesh('Cella', 'temple/cella', wall, { position: [0, floor, 0], parent: building });
  return building;
}

/** Adds a sunset: a warm sun from the left, whose shadows fall on the side of the lamps, a sky, and tone mapping. */
function lightEvening(build: SceneBuilder): void {
  Object.assign(build.scene.settings, {
    ...{ background: 'sky', sky: 'sunset', skyLight: false, backgroundIntensity: 0.6 },
    ...{ toneMapping: 'neutral', exposure: 1.1 },
  });
  const sun = { type: 'directional', diffuse: [1, 0.6, 0.36], intensity: 2.4, shadowExtent: 26 } as const;
  build.light('Sun', sun, [-14, 7, 20], [0, 3, 0]);
}

/** Adds four steady warm lamps in front of the columns, and two inside. */
function addSpots(build: SceneBuilder, castShadow: boolean): void {
  const { spacing } = templePlan;
  const { halfLength, floor } = templeSize;
  const spots = build.group('Spot lights');
  const warm = { type: 'spot', diffuse: [1, 0.72, 0.42], cutoff: 0.5, penumbra: 0.8, range: 14, castShadow } as const;
  for (const i of [-2.5, -1.5, 1.5, 2.5]) {
    const x = i * spacing;
    build.light(
      'Spot light',
      { ...warm, intensity: 38 },
      [x, 0.3, halfLength + 3.4],
      [x, floor + 4.5, halfLength],
      spots,
    );
  }
  for (const z of [-4, 4]) {
    build.light('Spot light', { ...warm, intensity: 30, cutoff: 0.7 }, [0, floor + 6, z], [0, floor, z], spots);
  }
}

/** Random position along the columns, from 1.8 m behind their axes to 3.2 m in front. */
function colonnadePlace(random: () => number): Vector3Tuple {
  const out = -1.8 + 5 * random() ** 1.3;
  const [x, z] = [templeSize.halfWidth + out, templeSize.halfLength + out];
  const along = random() * (x + z) * 2 - x - z;
  const side = random() < 0.5 ? -1 : 1;
  const y = 0.7 + 5 * random() ** 1.4;
  return Math.abs(along) < x
    ? [along, y, side * z]
    : [side * x, y, Math.sign(along) * (Math.abs(along) - x) * 2 - Math.sign(along) * z];
}

/**
 * A Doric temple on a green plane, weakly lit by a reddish sun, with moving point lights, a few of them away from the
 * temple (thesis 4.1 and 4.2.2).
 * @param lights - moving point lights, 0 or more
 * @param options - `evening` for a low sun, a sky and tone mapping
 */
export async function temple(
  lights: number,
  options: SceneBuildOptions & { readonly evening?: boolean } = {},
): Promise<Scene> {
  const { shadows = false, evening = false } = options;
  const build = new SceneBuilder('Temple', { ...options, shadows: shadows || evening });
  const { assets, settings } = build.scene;
  registerMeshes(assets, templeMeshes);
  settings.backgroundColour = [0.012, 0.016, 0.035];
  build.camera([13.5, 3.4, 22.5], [-0.4, 4.1, 3], { fov: 0.87, near: 0.2, far: 160 });
  build.mesh(
    'Ground',
    'plane',
    { map: 'grass', normalMap: 'grass-normal', colour: [0.75, 0.9, 0.7], repeat: 40, roughness: 0.95 },
    { scale: [120, 1, 120] },
  );
  addTemple(build);
  if (evening) lightEvening(build);
  else build.light('Sun', { type: 'directional', diffuse: [1, 0.5, 0.36], intensity: 0.8 }, [20, 16, 14], [0, 3, 0]);
  build.light(
    'Sky',
    { type: 'hemisphere', diffuse: [0.3, 0.38, 0.6], groundColour: [0.1, 0.12, 0.07], intensity: 0.5 },
    [0, 20, 0],
  );
  addSpots(build, shadows);
  const { range, intensity } = lightBudget(lights, { volume: 5600, range: 6, light: 20 });
  build.movingLights(lights, build.group('Lights'), (i, random) => ({
    position: colonnadePlace(random),
    extent: [1 + 2.5 * random(), 0.2 + 0.4 * random(), 1 + 3 * random()],
    speed: 0.6 + 1.2 * random(),
    range,
    intensity,
    castShadow: shadows && i < 2,
  }));
  return build.scene;
}
