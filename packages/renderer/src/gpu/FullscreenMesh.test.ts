import { expect, test } from 'vitest';
import { LightVolumeDraws } from '../techniques/light-volumes/LightVolumeDraws';
import { FullscreenMesh } from './FullscreenMesh';

/** three's WebGLBindingStates has a table for each geometry, removed only for geometries drawn in a scene. */
test('meshes without attributes share their geometry: what is made and disposed leaves no table in three', () => {
  expect(new FullscreenMesh().geometry).toBe(new FullscreenMesh().geometry);
  const geometries = () => {
    const draws = new LightVolumeDraws('', '', {}) as unknown as Record<string, { geometry: object }>;
    return ['spheres', 'cones', 'fields'].map((name) => draws[name].geometry);
  };
  const [one, other] = [geometries(), geometries()];
  expect(new Set(one).size).toBe(3);
  one.forEach((geometry, i) => expect(geometry).toBe(other[i]));
});
