import type { Light } from 'three';
import { hold, openLazy } from '../support/lateCode';
import { expect, test } from './perfTest';

test('after its first frame no technique compiles anything, whatever comes, goes or is chosen', async ({ page }) => {
  const steps = await page.evaluate(() => {
    const { perf, farolCounters, testPage } = window;
    const { three } = testPage;
    const world = perf.world('forward', { objects: 4, lights: 4, directional: 0 });
    const steps: { technique: string; step: string; programs: number }[] = [];
    const run = (step: string, work: () => void) => {
      const before = farolCounters.programs;
      work();
      steps.push({ technique: world.farol.technique, step, programs: farolCounters.programs - before });
    };
    for (const technique of perf.techniques) {
      world.farol.technique = technique;
      run('first', world.draw);
    }
    const kinds: Record<string, () => Light> = {
      point: () => new three.PointLight(0xffffff, 0.1, 2),
      unbounded: () => new three.PointLight(0xffffff, 0.1),
      spot: () => new three.SpotLight(0xffffff, 0.1, 2, 0.4),
      directional: () => new three.DirectionalLight(0xffffff, 0.1),
      hemisphere: () => new three.HemisphereLight(0xffffff, 0x000000, 0.1),
    };
    for (const technique of [...perf.techniques, ...perf.techniques.toReversed()]) {
      world.farol.technique = technique;
      run('switched to again', world.draw);
      for (const [kind, make] of Object.entries(kinds)) {
        const added = Array.from({ length: 10 }, make);
        for (const light of added) light.position.set(0, 0, 1);
        run(`10 ${kind} lights added`, () => {
          world.scene.add(...added);
          world.draw();
        });
        run(`10 ${kind} lights removed`, () => {
          world.scene.remove(...added);
          world.draw();
        });
      }
      run('all lights removed', () => {
        world.scene.remove(...world.lights);
        world.draw();
      });
      run('all lights back', () => {
        world.scene.add(...world.lights);
        world.draw();
      });
    }
    return steps;
  });
  const first = steps.filter(({ step }) => step === 'first');
  for (const { technique, programs } of first) {
    // one by one: a program may be shared with the technique before it
    expect(programs, `${technique}: programs of the first frame`).toBeLessThanOrEqual(12);
  }
  expect(first[0].programs, 'the counter sees programs').toBeGreaterThan(0);
  expect(steps.filter(({ step, programs }) => step !== 'first' && programs > 0)).toEqual([]);
});

test("'auto' compiles for two techniques while lights load and code comes late: one draws until the other's is there @verify", async ({
  page,
  pagesURL,
}) => {
  await openLazy(page, pagesURL);
  const release = await hold(page);
  const loading = await page.evaluate(() => {
    const { farolCounters, testPage } = window;
    const { Bench, compareImages, three } = testPage;
    const bench = new Bench(64, 48);
    const { farol } = bench;
    const scene = new three.Scene();
    const camera = new three.PerspectiveCamera(50, 64 / 48, 0.1, 30);
    camera.position.z = 6;
    const material = new three.MeshStandardMaterial();
    for (let i = 0; i < 12; i++) {
      const mesh = new three.Mesh(new three.SphereGeometry(0.5, 12, 8), material);
      mesh.position.set(1.2 * (i % 4) - 1.8, 1.2 * Math.floor(i / 4) - 1.2, 0);
      scene.add(mesh);
    }
    let programs = 0;
    /** Frames, each as the technique that drew it. */
    const frames: string[] = [];
    const draw = () => {
      const before = farolCounters.programs;
      const picture = bench.byTechnique('auto', scene, camera);
      programs += farolCounters.programs - before;
      frames.push(farol.info.technique);
      return picture;
    };
    let count = 0;
    const differences: number[] = [];
    for (const lights of [1, 12, 40]) {
      for (; count < lights; count++) {
        const light = new three.PointLight(0xffffff, 2, 4);
        light.position.set(2 * Math.sin(count), 1.5 * Math.cos(count), 1);
        scene.add(light);
      }
      differences.push(compareImages(bench.stock(scene, camera), draw()).psnr);
    }
    farol.addEventListener('redraw', draw);
    const settle = async () => {
      await farol.ready;
      differences.push(compareImages(bench.stock(scene, camera), draw()).psnr);
      return { programs, frames, differences };
    };
    Object.assign(window, { settle });
    return { frames: [...frames], programs };
  });
  expect(loading.programs, 'the counter sees programs').toBeGreaterThan(0);
  release();
  const { programs, frames, differences } = await page.evaluate(() =>
    (
      window as unknown as { settle(): Promise<{ programs: number; frames: string[]; differences: number[] }> }
    ).settle(),
  );
  expect.soft(loading.frames).toEqual(['forward-single-pass', 'forward-single-pass', 'forward-single-pass']);
  expect(frames.at(-1)).toBe('clustered-deferred');
  for (const psnr of differences) expect(psnr, "from stock three's picture (dB)").toBeGreaterThan(60);
  expect(programs, 'programs in all').toBeLessThanOrEqual(4);
});
