import {
  type Camera,
  type Light,
  Matrix4,
  OrthographicCamera,
  PerspectiveCamera,
  PointLight,
  SpotLight,
  Vector3,
} from 'three';
import { describe, expect, it, vi } from 'vitest';
import { lightRange } from './lightData';
import { POINT, readPoint } from './plainPoints';
import { createRandom, randomDirection } from './testing/testScenes';
import { VisibleLights } from './VisibleLights';

const settings = { shadows: 'none', layers: null } as const;

/** The two kinds of depth that three's projections have. */
interface Depths {
  readonly reversed: boolean;
}

function perspective({ reversed }: Depths): PerspectiveCamera {
  const camera = new PerspectiveCamera(55, 1.6, 0.5, 40);
  const side = 0.5 * Math.tan((camera.fov * Math.PI) / 360);
  camera.projectionMatrix.makePerspective(-1.6 * side, 1.6 * side, side, -side, 0.5, 40, undefined, reversed);
  return camera;
}

function offCentre({ reversed }: Depths): PerspectiveCamera {
  const camera = new PerspectiveCamera(55, 1.6, 0.5, 40);
  camera.projectionMatrix.makePerspective(-0.1, 0.5, 0.05, -0.4, 0.5, 40, undefined, reversed);
  return camera;
}

function orthographic({ reversed }: Depths): OrthographicCamera {
  const camera = new OrthographicCamera(-9, 9, 6, -6, 0.5, 40);
  camera.projectionMatrix.makeOrthographic(-9, 9, 6, -6, 0.5, 40, undefined, reversed);
  return camera;
}

/** Places a camera at random, and updates its matrices. */
function placed(camera: Camera, random: () => number): Camera {
  camera.position.set(random() * 20 - 10, random() * 20 - 10, random() * 20 - 10);
  camera.lookAt(new Vector3(random() * 20 - 10, random() * 20 - 10, random() * 20 - 10));
  camera.updateMatrixWorld();
  camera.projectionMatrixInverse.copy(camera.projectionMatrix).invert();
  return camera;
}

/** Lights around a camera at `centre`, up to twice as far as its far plane. */
function randomLights(count: number, random: () => number, centre: Vector3): Light[] {
  return Array.from({ length: count }, (_, i) => {
    const range = 0.5 + 12 * random() ** 2;
    const light =
      i % 3 === 0
        ? new PointLight(0xffffff, 1, range)
        : // wide cones up to a half space, since narrow ones are bounded differently
          new SpotLight(0xffffff, 1, range, 0.03 + (Math.PI / 2 - 0.03) * random());
    if (i % 5 === 0) {
      light.distance = 0;
      light.userData.farol = { attenuation: { kind: 'near-far', near: 0.9 * range, far: range } };
    }
    const [x, y, z] = randomDirection(random);
    light.position
      .set(x, y, z)
      .multiplyScalar(45 * random())
      .add(centre);
    light.updateMatrixWorld();
    if (light instanceof SpotLight) {
      const [dx, dy, dz] = randomDirection(random);
      light.target.position.set(dx, dy, dz).add(light.position);
      light.target.updateMatrixWorld();
    }
    return light;
  });
}

/** A point that a light reaches, most often at the end of its range or at the side of its cone. */
function reachedPoint(light: Light, random: () => number, point: Vector3): Vector3 {
  const range = lightRange(light as PointLight);
  const length = range * (random() < 0.7 ? 0.9999 : Math.cbrt(random()));
  const [x, y, z] = randomDirection(random);
  point.set(x, y, z);
  if (light instanceof SpotLight) {
    const axis = light.target.position.clone().sub(light.position).normalize();
    const side = point.cross(axis).normalize();
    const angle = light.angle * (random() < 0.6 ? 0.9999 : random());
    point = side.multiplyScalar(Math.sin(angle)).addScaledVector(axis, Math.cos(angle));
  }
  return point.multiplyScalar(length).add(light.position);
}

const cameras = { perspective, 'off-centre perspective': offCentre, orthographic };

describe.each(
  Object.entries(cameras).flatMap(([name, make]) => [
    { name, make, reversed: false },
    { name: `${name}, reversed depth`, make, reversed: true },
  ]),
)('the lights that a camera may see, $name', ({ make, reversed }) => {
  it('leave out no light that reaches a point of the frustum', () => {
    const random = createRandom(17);
    const visible = new VisibleLights();
    const point = new Vector3();
    const clip = new Vector3();
    const viewProjection = new Matrix4();
    let reaching = 0;
    let culled = 0;
    for (let turn = 0; turn < 4; turn++) {
      const camera = placed(make({ reversed }), random);
      viewProjection.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
      const lights = randomLights(600, random, camera.position);
      visible.collect(lights, camera, settings);
      const kept = new Set(visible.boundeds);
      culled += lights.length - kept.size;
      for (const light of lights) {
        for (let sample = 0; sample < 150; sample++) {
          reachedPoint(light, random, point);
          const depth = -clip.copy(point).applyMatrix4(camera.matrixWorldInverse).z;
          if (depth < 0.5 || depth > 40) continue;
          clip.copy(point).applyMatrix4(viewProjection);
          if (Math.abs(clip.x) > 1 || Math.abs(clip.y) > 1) continue;
          reaching++;
          if (!kept.has(light)) expect.fail(`a ${light.type} that reaches ${point.toArray().join()} is left out`);
          break;
        }
      }
    }
    expect(reaching).toBeGreaterThan(200);
    expect(culled).toBeGreaterThan(1000);
  });

  it('have in their bounds each point that they reach: sphere, axis and cutoff in view space', () => {
    const random = createRandom(19);
    const camera = placed(make({ reversed }), random);
    const lights = randomLights(300, random, camera.position);
    const visible = new VisibleLights();
    visible.collect(lights, camera, settings);
    const point = new Vector3();
    visible.boundeds.forEach((light, k) => {
      const [x, y, z, radius] = visible.spheres.subarray(k * 4, k * 4 + 4);
      const [ax, ay, az, cutoff] = visible.cones.subarray(k * 4, k * 4 + 4);
      expect(radius).toBe(lightRange(light as PointLight));
      for (let sample = 0; sample < 30; sample++) {
        reachedPoint(light, random, point).applyMatrix4(camera.matrixWorldInverse);
        const toLight = new Vector3(x, y, z).sub(point);
        expect(toLight.length()).toBeLessThanOrEqual(radius);
        const cosine = (toLight.x * ax + toLight.y * ay + toLight.z * az) / toLight.length();
        expect(cosine).toBeGreaterThanOrEqual(cutoff - 1e-9);
      }
    });
    expect(visible.coneCount).toBeGreaterThan(10);
    expect(visible.sphereCount).toBeGreaterThan(10);
    expect(visible.coneCount + visible.sphereCount).toBe(visible.boundeds.length);
  });
});

it('has plain point lights as their class has them, read before or not', () => {
  const random = createRandom(23);
  const camera = placed(perspective({ reversed: false }), random);
  const pick = <T>(usual: T, ...rare: T[]): T => (random() < 0.9 ? usual : rare[Math.floor(random() * rare.length)]);
  const lights = randomLights(600, random, camera.position).map(({ position }) => {
    const light = new PointLight(
      pick(0x8899aa, 0x000000),
      pick(2, 0, NaN),
      pick(5, 0, Infinity, -1),
      pick(2, 0, -1, NaN),
    );
    light.position.copy(position);
    light.position.x = pick(position.x, NaN, Infinity);
    light.updateMatrixWorld();
    return light;
  });
  const points = new Float64Array(lights.length * POINT);
  lights.forEach((light, i) => readPoint(light, points, i * POINT));
  const warn = vi.spyOn(console, 'warn').mockImplementation(() => undefined);
  const figures = (isRead: boolean): unknown[] => {
    const visible = new VisibleLights();
    visible.collect(lights, camera, settings, isRead ? points : null);
    const { boundeds, unboundeds, coverage, sphereCount, coneCount, spheres, cones } = visible;
    const used = boundeds.length * 4;
    const bounds = [...spheres.subarray(0, used), ...cones.subarray(0, used)];
    return [[...boundeds], [...unboundeds], visible.visible, coverage, sphereCount, coneCount, bounds];
  };
  const plain = figures(true);
  const warnings = warn.mock.calls.length;
  expect(figures(false)).toEqual(plain);
  for (const light of lights) light.userData.farol = {}; // lights of another class, with empty options
  expect(figures(false)).toEqual(plain);
  expect(warn.mock.calls.length).toBe(3 * warnings);
  expect(warnings).toBeGreaterThan(10);
  expect(plain[2]).toBeGreaterThan(100);
  expect((plain[1] as Light[]).length).toBeGreaterThan(5);
});

it.each(['none', 'all-but-points', 'all'] as const)(
  'has a point light that would cast a shadow as a plain one, unless it has a map: maps of %s',
  (shadows) => {
    const light = new PointLight(0x336699, 3, 4, 1.5);
    light.castShadow = true;
    const camera = new PerspectiveCamera();
    const visible = new VisibleLights();
    visible.collect([light], camera, { shadows, layers: null });
    const { r, g, b } = light.color;
    const decay = shadows === 'all' ? -1 : 1.5;
    expect([...visible.emissions.subarray(0, 4)]).toEqual([r * 3, g * 3, b * 3, decay]);
    expect(visible.masked).toEqual(shadows === 'all' ? [light] : []);
  },
);

it.each<[string, number, (light: PointLight) => unknown]>([
  ['as it is made', 2, () => 0],
  ['that casts a shadow', NaN, (light) => (light.castShadow = true)],
  ['with settings of its own', NaN, ({ userData }) => (userData.farol = {})],
  ['with an image', NaN, ({ userData }) => (userData.farolMap = {})],
  ['with a profile', NaN, ({ userData }) => (userData.farolProfile = {})],
  ['whose colour is no number', NaN, ({ color }) => (color.g = NaN)],
])('reads a point light %s: its decay, or NaN', (_, decay, change) => {
  const light = new PointLight(0x808080, 3, 4);
  change(light);
  const points = new Float64Array(POINT).fill(7);
  readPoint(light, points, 0);
  expect(points[7]).toBe(decay);
});
