import type { TechniqueName } from '@farol/renderer';
import type * as Three from 'three';
import { expect, test } from '../support/test';

/**
 * Bounds of lights on the GPU and in the draws of each technique (volumes, lists of tiles, scissors and objects of multipass
 * lighting) against `forward-single-pass`, which goes through all lights for every pixel. Lights reach their end almost
 * at full strength and light whatever the normal, so that a bound too small by a twentieth shows.
 */
test('no light is cut short by what a technique bounds it by: points, plain ones and cones', async ({
  benchPage: page,
}) => {
  const found = await page.evaluate(() => {
    const { Bench, three } = window.testPage;
    const [width, height] = [192, 108];
    const bench = new Bench(width, height);
    bench.farol.inferredScale = 1;
    let seed = 7;
    const random = (low: number, high: number) => {
      seed = (Math.imul(seed, 1103515245) + 12345) >>> 0;
      return low + ((high - low) * (seed >>> 8)) / 2 ** 24;
    };
    const scene = new three.Scene();
    const material = new three.MeshLambertMaterial();
    const panel = new three.PlaneGeometry(1.5, 1.3);
    const place = (row: number, column: number, depth: number) =>
      new three.Vector3((column - 5.5) * 1.4, (row - 3) * 1.2, depth);
    // panels side by side, each at a depth of its own, under a light or two of its own
    for (let row = 0; row < 7; row++) {
      for (let column = 0; column < 12; column++) {
        const mesh = new three.Mesh(panel, material);
        mesh.position.copy(place(row, column, random(-3, 1)));
        mesh.rotation.set(random(-0.5, 0.5), random(-0.5, 0.5), 0);
        scene.add(mesh);
      }
    }
    const near = (light: Three.PointLight | Three.SpotLight, range: number) => {
      light.userData.farol = { ambient: [1, 1, 1], attenuation: { kind: 'near-far', near: 0.9 * range, far: range } };
      return light;
    };
    const lights = new three.Group();
    scene.add(lights);
    for (let i = 0; i < 60; i++) {
      const range = random(0.4, 2.2);
      const at = place(random(0, 7), random(0, 12), random(-3, 1));
      let light: Three.PointLight | Three.SpotLight;
      if (i % 3 === 0) light = near(new three.PointLight(0x000000, 1), range);
      // as three has it: plain; weak at its end, hence so bright
      else if (i % 3 === 1) light = new three.PointLight(0xffffff, 60, range, 0);
      else {
        // exponent 0: the cone has a hard side; angles on both sides of where cones give way to spheres
        light = near(new three.SpotLight(0x000000, 1, 0, i % 2 ? random(0.1, 1) : random(1, 1.4)), 1.6 * range);
        light.userData.farol.spotExponent = 0;
        (light as Three.SpotLight).target.position.set(random(-1, 1), random(-1, 1), random(-1, 1)).add(at);
        lights.add((light as Three.SpotLight).target);
      }
      light.position.copy(at);
      lights.add(light);
    }
    const perspective = new three.PerspectiveCamera(50, width / height, 0.3, 30);
    perspective.position.set(0.3, 0.2, 8);
    // among the lights and panels
    const inside = new three.PerspectiveCamera(70, width / height, 0.05, 30);
    inside.position.set(-1, 0.5, 1.2);
    inside.rotation.y = 0.3;
    const orthographic = new three.OrthographicCamera(-7, 7, 4, -4, 0.5, 20);
    orthographic.position.set(0, 0, 8);
    const cameras = { perspective, inside, orthographic };
    const results: { name: string; lit: number; cut: number; worst: number }[] = [];
    for (const [view, camera] of Object.entries(cameras)) {
      const all = bench.byTechnique('forward-single-pass', scene, camera).data;
      for (const technique of ['forward', 'deferred', 'tiled-forward', 'forward-plus'] as TechniqueName[]) {
        const { data } = bench.byTechnique(technique, scene, camera);
        let [lit, cut, worst] = [0, 0, 0];
        for (let i = 0; i < data.length; i += 4) {
          if (all[i] < 0.02) continue;
          lit++;
          const missing = (all[i] - data[i]) / all[i];
          worst = Math.max(worst, missing);
          if (missing > 0.2) cut++;
        }
        results.push({ name: `${technique}, ${view}`, lit, cut, worst });
      }
    }
    return results;
  });
  for (const { name, lit, cut, worst } of found) {
    console.log(name, lit, cut, worst);
    expect.soft(cut, name).toBeLessThanOrEqual(name.startsWith('deferred') ? 0.004 * lit : 0);
    expect.soft(lit, name).toBeGreaterThan(3000);
  }
});
