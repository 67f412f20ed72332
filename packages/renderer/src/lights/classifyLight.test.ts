import {
  AmbientLight,
  DirectionalLight,
  HemisphereLight,
  type Light,
  LightProbe,
  PerspectiveCamera,
  PointLight,
  RectAreaLight,
  SpotLight,
  Texture,
} from 'three';
import { describe, expect, it } from 'vitest';
import { classifyLight, hasCookie, hasShadowMap, isManagedLight, mayBeMasked } from './classifyLight';
import type { FarolLightData } from './lightData';
import { VisibleLights } from './VisibleLights';

function withData<L extends Light>(light: L, farol: FarolLightData): L {
  light.userData.farol = farol;
  return light;
}

const nothing = { shadows: 'none', layers: null } as const;

describe('the class of a light', () => {
  const nearFar = { attenuation: { kind: 'near-far', near: 1, far: 2 } } as const;
  it.each([
    [new AmbientLight(), 'ambient'],
    [new HemisphereLight(), 'hemisphere'],
    [new DirectionalLight(), 'directional'],
    [new PointLight(0xffffff, 1, 0), 'unbounded'],
    [new SpotLight(0xffffff, 1, 0), 'unbounded'],
    [new PointLight(0xffffff, 1, 5), 'point'],
    [withData(new PointLight(0xffffff, 1, 5), {}), 'extended-point'],
    [withData(new PointLight(0xffffff, 1, 0), nearFar), 'extended-point'],
    [new SpotLight(0xffffff, 1, 5), 'spot'],
    [withData(new SpotLight(0xffffff, 1, 0), nearFar), 'spot'],
    [new RectAreaLight(), 'area'],
    [new LightProbe(), 'other'],
  ] as const)('%# is %s', (light, expected) => {
    expect(classifyLight(light)).toBe(expected);
    expect(isManagedLight(light, { shadows: false, cookies: false, areas: false, all: false })).toBe(
      expected !== 'other',
    );
    expect(isManagedLight(light, { shadows: false, cookies: false, areas: false, all: true })).toBe(false);
    const managedWithoutAreas = expected !== 'other' && expected !== 'area';
    expect(isManagedLight(light, { shadows: false, cookies: false, areas: true, all: false })).toBe(
      managedWithoutAreas,
    );
  });

  it('knows a field of lights, which three cannot draw', () => {
    const field = Object.assign(new LightProbe() as Light, { isLightField: true });
    expect(classifyLight(field)).toBe('field');
    expect(isManagedLight(field, { shadows: true, cookies: true, areas: true, all: true })).toBe(true);
  });

  it('says what may mask it', () => {
    const point = new PointLight(0xffffff, 1, 5);
    const spot = new SpotLight(0xffffff, 1, 5);
    expect([point, spot].map((light) => mayBeMasked(light, nothing))).toEqual([false, false]);
    spot.map = new Texture();
    expect([point, spot].map(hasCookie)).toEqual([false, true]);
    expect(isManagedLight(spot, { shadows: false, cookies: true, areas: false, all: false })).toBe(false);
    point.castShadow = true;
    expect(mayBeMasked(point, nothing)).toBe(false);
    expect(mayBeMasked(point, { ...nothing, shadows: 'all' })).toBe(true);
    expect(mayBeMasked(point, { ...nothing, shadows: 'all-but-points' })).toBe(false);
    expect(hasShadowMap(point, 'all')).toBe(true);
    expect(hasShadowMap(new PointLight(), 'all')).toBe(false);
    spot.map = null;
    spot.castShadow = true;
    expect(mayBeMasked(spot, { ...nothing, shadows: 'all-but-points' })).toBe(true);
    expect(mayBeMasked(new DirectionalLight(), { ...nothing, layers: { separates: () => true } })).toBe(true);
  });
});

describe('the visible lights of a frame', () => {
  const camera = new PerspectiveCamera(60, 1, 0.1, 100);
  camera.updateMatrixWorld();

  function at<L extends Light>(light: L, x: number, y: number, z: number): L {
    light.position.set(x, y, z);
    light.updateMatrixWorld();
    return light;
  }

  it('are what the camera sees, by class, each counted once', () => {
    const lights = new VisibleLights();
    const point = at(new PointLight(0xffffff, 2, 5), 0, 0, -10);
    const extended = at(withData(new PointLight(0xffffff, 1, 5), {}), 1, 0, -10);
    const spot = at(new SpotLight(0xffffff, 1, 5, 0.5), 0, 1, -10);
    const shadowed = at(new PointLight(0xffffff, 1, 5), 2, 0, -10);
    shadowed.castShadow = true;
    const endless = at(new PointLight(0xffffff, 1, 0), 500, 0, 0);
    const sun = new DirectionalLight();
    const out = [at(new PointLight(0xffffff, 1, 5), 0, 0, 50), at(new PointLight(0x000000, 1, 5), 0, 0, -10)];
    const all = [point, extended, spot, shadowed, endless, sun, ...out, new AmbientLight()];
    for (let i = 0; i < 2; i++) lights.collect(all, camera, { shadows: 'all', layers: null });
    expect(lights.boundeds).toEqual([point, extended, spot, shadowed]);
    expect([lights.directionals, lights.unboundeds, lights.masked]).toEqual([[sun], [endless], [shadowed]]);
    expect([lights.sphereCount, lights.coneCount, lights.total, lights.visible]).toEqual([3, 1, 9, 7]);
    expect([...lights.emissions.slice(0, 4)]).toEqual([2, 2, 2, 2]);
    expect([7, 11, 15].map((w) => lights.emissions[w])).toEqual([-1, -1, -1]);
    expect([...lights.spheres.slice(0, 4)]).toEqual([0, 0, -10, 5]);
    expect(lights.coverage).toBeGreaterThan(0);
  });
});
