import type { Difference } from '../support/images';
import { expect, test } from '../support/benchTest';

test('thousands of point lights, which the GPU sorts, look as when the CPU sorts them @verify', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(async () => {
    const { Bench, compareImages, randomIn, three } = window.testPage;
    const width = 48;
    const height = 32;
    const bench = new Bench(width, height);
    const random = randomIn(5);
    const scene = new three.Scene();
    const floor = new three.Mesh(new three.PlaneGeometry(24, 24), new three.MeshStandardMaterial({ roughness: 0.6 }));
    floor.rotation.x = -Math.PI / 2;
    const beam = new three.SpotLight(0xffffff, 20, 9, 0.5, 0.3);
    beam.position.set(-3, 4, 2);
    scene.add(floor, beam, beam.target, new three.AmbientLight(0x112233));
    const lights = Array.from({ length: 4200 }, () => {
      const light = new three.PointLight(0xffffff, 0.05, random(0.2, 1), random(1, 2));
      light.color.setRGB(random(0, 1), random(0, 1), random(0, 1));
      light.position.set(random(-6, 6), random(0.1, 0.5), random(-6, 4));
      return light;
    });
    scene.add(...lights);
    const camera = new three.PerspectiveCamera(50, width / height, 0.1, 60);
    camera.position.set(0, 4, 9);
    camera.lookAt(0, 0, -1);
    const isPacked = () => bench.farol.info.passes.some(({ name }) => name === 'light fields');
    const found: (Difference & { name: string })[] = [];
    const compare = async (name: string) => {
      // packs no lights, and no frame of 'tiled-deferred' does until its programs are linked
      const alone = bench.byTechnique('clustered-deferred', scene, camera);
      let picture = bench.byTechnique('tiled-deferred', scene, camera);
      while (!isPacked()) {
        await new Promise(requestAnimationFrame);
        picture = bench.byTechnique('tiled-deferred', scene, camera);
      }
      found.push({ name, ...compareImages(alone, picture) });
    };
    await compare('first');
    const { total, visible } = bench.farol.info.lights;
    const before = bench.programs;
    for (const light of lights) light.position.x += 0.1;
    scene.remove(lights[12]);
    await compare('moved');
    const programs = bench.programs - before;
    lights[7].distance = 0;
    lights[8].decay = -1;
    lights[9].userData.farol = { attenuation: { kind: 'near-far', near: 0.2, far: 1 } };
    lights[10].visible = false;
    lights[11].color.setRGB(1, 0, 0);
    lights[11].intensity = 4;
    await compare('changed');
    bench.webgl.shadowMap.enabled = true;
    beam.castShadow = floor.receiveShadow = true;
    await compare('with a shadow map');
    scene.position.set(30_000, 0, 30_000);
    camera.position.add(scene.position);
    await compare('far away');
    camera.position.sub(scene.position);
    scene.position.set(0, 0, 0);
    // most lights behind the camera
    camera.position.z = -5.5;
    camera.lookAt(0, 0, -12);
    bench.byTechnique('clustered-deferred', scene, camera);
    bench.byTechnique('tiled-deferred', scene, camera);
    const behind = isPacked();
    camera.position.z = 9;
    camera.lookAt(0, 0, -1);
    for (const light of lights.slice(200)) scene.remove(light);
    bench.byTechnique('tiled-deferred', scene, camera);
    bench.byTechnique('tiled-deferred', scene, camera);
    return { found, total, visible, programs, behind, few: isPacked() };
  });
  for (const { name, largest } of results.found) expect(largest, name).toBeLessThan(2e-3);
  expect(results.total).toBe(4202);
  expect(results.visible).toBeGreaterThan(3000);
  expect(results.visible).toBeLessThanOrEqual(4202);
  expect(results.programs).toBe(0);
  expect([results.behind, results.few]).toEqual([false, false]);
});
