import {
  Mesh,
  MeshStandardMaterial,
  PerspectiveCamera,
  PlaneGeometry,
  PointLight,
  Scene,
  SpotLight,
  TorusKnotGeometry,
  Vector3,
} from 'three';
import { expect, test } from 'vitest';
import { CasterRuns } from './CasterRuns';
import { isReached, isSeen, ShadowCasters } from './ShadowCasters';
import { ShadowSlot, type ShadowLight } from './ShadowSlot';

function random(seed: number): () => number {
  return () => {
    seed = (seed * 16807) % 2147483647;
    return (seed - 1) / 2147483646;
  };
}

test('every triangle that has a corner in a face’s view and the light’s range is in the runs of that face', () => {
  const next = random(5);
  const scene = new Scene();
  const geometries = [new TorusKnotGeometry(3, 0.5, 400, 24), new PlaneGeometry(20, 20, 100, 100).toNonIndexed()];
  const meshes = geometries.map((geometry) => new Mesh(geometry, new MeshStandardMaterial()));
  for (const mesh of meshes) {
    mesh.castShadow = true;
    mesh.rotation.set(next() * 6, next() * 6, next() * 6);
    mesh.scale.set(1, 0.7, -1.3);
  }
  scene.add(...meshes);
  const camera = new PerspectiveCamera();
  const casters = new ShadowCasters();
  const runs = new CasterRuns();
  const point = new Vector3();
  let whole = 0;
  let drawn = 0;
  for (let round = 0; round < 12; round++) {
    for (const mesh of meshes) mesh.position.set(next() * 4 - 2, next() * 4 - 2, next() * 4 - 2);
    scene.updateMatrixWorld();
    casters.update(scene, camera, false);
    const range = round % 4 === 3 ? 0 : 2 + 3 * next();
    const light: ShadowLight =
      round % 2 === 0 ? new PointLight(0xffffff, 1, range) : new SpotLight(0xffffff, 1, range, 0.5);
    light.position.set(next() * 6 - 3, next() * 6 - 3, next() * 6 - 3);
    light.updateMatrixWorld();
    const slot = new ShadowSlot(light);
    slot.place({ x: 0, y: 0, width: 256, height: 256 }, 64, 64);
    slot.follow(false, camera);
    for (let c = 0; c < casters.count; c++) {
      const caster = casters.list[c];
      if (!isReached(caster, slot)) continue;
      expect(runs.begin(caster, slot)).toBe(true);
      const { geometry, matrixWorld } = caster.object as Mesh;
      const { position } = geometry.attributes;
      const vertices = geometry.index?.count ?? position.count;
      for (const face of slot.faces) {
        face.clear();
        if (isSeen(caster, face)) runs.addTo(face, caster);
        const covered = new Uint8Array(vertices);
        face.starts.forEach((start, i) => covered.fill(1, start, start + face.counts[i]));
        for (let i = 0; i < vertices; i++) {
          point.fromBufferAttribute(position, geometry.index?.getX(i) ?? i).applyMatrix4(matrixWorld);
          if (range > 0 && point.distanceTo(light.position) > range) continue;
          const { planes } = face;
          let inside = true;
          for (let p = 0; p < 24; p += 4) {
            inside &&= planes[p] * point.x + planes[p + 1] * point.y + planes[p + 2] * point.z + planes[p + 3] >= 0;
          }
          if (inside && covered[i] === 0) expect.fail(`round ${round}: vertex ${i} is seen and not drawn`);
        }
        whole += vertices;
        drawn += covered.reduce((sum, one) => sum + one, 0);
      }
    }
  }
  expect(drawn).toBeGreaterThan(0);
  expect(drawn).toBeLessThan(0.7 * whole);
});
