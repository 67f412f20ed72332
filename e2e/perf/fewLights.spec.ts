import { expect, test } from './perfTest';

test('a frame of few lights calls WebGL as stock three’s does, asks once more whether the context is lost, and lets the GPU begin', async ({
  page,
}) => {
  const measured = await page.evaluate(() => {
    const { perf } = window;
    const gl = WebGL2RenderingContext.prototype as unknown as Record<string, unknown>;
    const callsOf = (frame: () => void): Record<string, number> => {
      const calls: Record<string, number> = {};
      const methods = Object.entries(Object.getOwnPropertyDescriptors(gl)).filter(
        ([, { value }]) => typeof value === 'function',
      );
      for (const [name, { value }] of methods)
        gl[name] = function (...values: unknown[]) {
          calls[name] = (calls[name] ?? 0) + 1;
          return (value as (...values: unknown[]) => unknown).apply(this, values);
        };
      frame();
      for (const [name, { value }] of methods) gl[name] = value;
      return calls;
    };
    perf.drawNothing(); // the calls are counted all the same
    return [
      [1, 1, 0],
      [225, 1, 0],
      [225, 1, 1],
    ].map(([objects, lights, directional]) => {
      const world = perf.world('auto', { objects, lights, directional });
      const { farol, scene, camera } = world;
      const counted = [() => farol.webgl.render(scene, camera), () => farol.render(scene, camera)].map((draw) => {
        const frame = () => {
          world.lights[0].position.x += 0.001;
          draw();
        };
        for (let i = 0; i < 3; i++) frame(); // uploads and programs
        return callsOf(frame);
      });
      const { technique } = farol.info;
      world.dispose();
      return { objects, technique, counted };
    });
  });

  for (const { objects, technique, counted } of measured) {
    const name = `${objects} objects`;
    const [stock, farol] = counted.map((calls) => Object.values(calls).reduce((sum, count) => sum + count, 0));
    expect(technique, name).toBe('forward-single-pass');
    const flushes = objects > 1 ? 1 : 0;
    expect(counted[1].flush ?? 0, `${name}: flushes`).toBe(flushes);
    expect(farol, `${name}: ${JSON.stringify(counted)}`).toBeLessThanOrEqual(stock + 1 + flushes);
    expect(counted[1].drawElements, `${name}: draws`).toBe(objects);
  }
});

test('a frame makes the matrices of its camera once, and gives the camera back before code of the host runs', async ({
  page,
}) => {
  const seen = await page.evaluate(() => {
    const { perf } = window;
    perf.drawNothing();
    const world = perf.world('auto', { objects: 1, lights: 1, directional: 0 });
    const { camera, scene, objects } = world;
    world.draw();
    let updates = 0;
    const updating: boolean[] = [];
    const { updateMatrixWorld } = camera;
    camera.updateMatrixWorld = (force) => {
      updates++;
      updateMatrixWorld.call(camera, force);
    };
    const note = () => void updating.push(camera.matrixWorldAutoUpdate);
    objects[0].onBeforeRender = note;
    scene.onAfterRender = note;
    const counts = [0.1, 0.2].map((x) => {
      updates = 0;
      camera.position.x = x;
      world.draw();
      return [updates, camera.matrixWorldInverse.elements[12]];
    });
    camera.matrixWorldAutoUpdate = false;
    updates = 0;
    world.draw();
    const off = [updates, camera.matrixWorldAutoUpdate];
    world.dispose();
    return { counts, updating: updating.slice(0, 4), off };
  });
  expect(seen.counts).toEqual([
    [1, -0.1],
    [1, -0.2],
  ]);
  expect(seen.updating).toEqual([true, true, true, true]);
  expect(seen.off).toEqual([0, false]);
});

test('lights are as in stock three whether they are few enough to be uniforms, plain or not', async ({ page }) => {
  const differences = await page.evaluate(() => {
    const { Bench, compareImages, three } = window.testPage;
    const bench = new Bench(48, 32);
    const scene = new three.Scene();
    const camera = new three.PerspectiveCamera(50, 1.5, 0.1, 20);
    camera.position.z = 3;
    const sphere = new three.SphereGeometry(0.8, 24, 16);
    [new three.MeshStandardMaterial(), new three.MeshToonMaterial(), new three.MeshPhongMaterial()].forEach(
      (material, i) => {
        const mesh = new three.Mesh(sphere, material);
        mesh.position.x = 1.4 * (i - 1);
        scene.add(mesh);
      },
    );
    const point = (x: number) => {
      const light = new three.PointLight(0xff8040, 4, 6);
      light.position.set(x, 1, 2);
      return light;
    };
    const sun = new three.DirectionalLight(0x4080ff, 1);
    const spot = new three.SpotLight(0x80ff40, 20, 9, 0.3, 0.4);
    spot.position.set(1, 0, 3);
    const endless = new three.PointLight(0xffffff, 3);
    endless.position.set(0, 2, 2);
    const [left, right] = [point(-1), point(1)];
    const sets = {
      none: [],
      left: [left],
      sun: [sun, left],
      three: [sun, left, right],
      spot: [spot],
      endless: [endless, right],
    };
    const order = ['none', 'left', 'sun', 'three', 'left', 'spot', 'endless', 'three', 'sun', 'none'] as const;
    return order.map((name) => {
      scene.remove(left, right, sun, spot, endless);
      if (sets[name].length > 0) scene.add(...sets[name]);
      const stock = bench.stock(scene, camera);
      return { name, ...compareImages(stock, bench.byTechnique('forward-single-pass', scene, camera)) };
    });
  });

  for (const { name, psnr } of differences) expect(psnr, name).toBeGreaterThan(60);
});
