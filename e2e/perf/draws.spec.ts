import { budgetOf, drawsByLight } from './budgets';
import { expect, test } from './perfTest';

const OBJECTS = 25;

test('draw calls and passes stay within each technique’s formula, and do not grow with the lights', async ({
  page,
}) => {
  const measured = await page.evaluate((objects) => {
    const { perf } = window;
    perf.drawNothing(); // the calls are counted all the same
    return perf.techniques.flatMap((technique) =>
      [150, 300].map((lights) => {
        const world = perf.world(technique, { objects, lights, spots: 30 });
        for (let i = 0; i < 3; i++) world.draw(); // auto may look at a frame before it picks
        const { draws } = world.count();
        const { info } = world.farol;
        const result = {
          ...{ technique, drawn: info.technique, lights, draws, told: info.drawCalls },
          ...{ passes: info.passes.map(({ name }) => name), visible: info.lights.visible },
        };
        world.dispose();
        return result;
      }),
    );
  }, OBJECTS);

  for (const { technique, drawn, lights, draws, told, passes, visible } of measured) {
    const name = `${technique}, ${lights} lights`;
    const budget = budgetOf(drawn);
    // one directional light reaches everything, every other light one box
    const most = budget.draws({ objects: OBJECTS, pairs: OBJECTS + lights });
    expect(visible, `${name}: lights drawn`).toBe(lights + 1);
    expect(told, `${name}: draw calls`).toBeLessThanOrEqual(most);
    expect(told, `${name}: draw calls, every object once`).toBeGreaterThanOrEqual(OBJECTS);
    expect(draws, `${name}: draw calls as WebGL counts them`).toBe(told);
    expect(passes.length, `${name}: passes ${passes.join(', ')}`).toBeLessThanOrEqual(budget.passes);
  }
  for (const { technique, told, drawn } of measured.filter(({ lights }) => lights === 150)) {
    const more = measured.find((other) => other.technique === technique && other.lights === 300)!;
    if (more.drawn !== drawn || drawsByLight.has(drawn)) continue; // auto may pick another
    expect(more.told, `${technique}: draw calls under 300 lights and under 150`).toBe(told);
  }
});

test('three reads the host’s materials, not their twins, and a frame of 25 draws is flushed once', async ({ page }) => {
  const measured = await page.evaluate(() => {
    const { perf, testPage } = window;
    const { three } = testPage;
    const bench = new testPage.Bench(32, 32);
    const camera = new three.PerspectiveCamera(50, 1, 0.1, 20);
    camera.position.z = 8;
    const material = new three.MeshStandardMaterial();
    const count = (technique: (typeof perf.techniques)[number], lights: number) => {
      const scene = new three.Scene();
      for (let i = 0; i < 25; i++) {
        const mesh = new three.Mesh(new three.PlaneGeometry(), material);
        mesh.position.set((i % 5) - 2, Math.floor(i / 5) - 2, 0);
        scene.add(mesh);
      }
      for (let i = 0; i < lights; i++) scene.add(new three.PointLight(0xffffff, 1, 10));
      bench.byTechnique(technique, scene, camera);
      bench.farol.render(scene, camera); // the canvas takes another program than the target before
      const { webgl } = bench.farol;
      const gl = webgl.getContext();
      const { state } = webgl;
      const { setMaterial } = state;
      const result = { technique, lights, ofHost: 0, flushes: 0, isRestored: false };
      const { properties, getRenderTarget } = webgl;
      const { get } = properties;
      state.setMaterial = (drawn, ...rest) => {
        if (drawn === material) result.ofHost++;
        setMaterial(drawn, ...rest);
      };
      gl.flush = () => void result.flushes++;
      bench.farol.render(scene, camera);
      Object.assign(state, { setMaterial });
      delete (gl as Partial<WebGL2RenderingContext>).flush;
      result.isRestored = properties.get === get && webgl.getRenderTarget === getRenderTarget;
      return result;
    };
    return [
      count('forward-single-pass', 3),
      count('clustered-forward', 3),
      count('deferred', 3),
      count('forward-single-pass', 8),
    ];
  });

  for (const { technique, lights, ofHost, flushes, isRestored } of measured) {
    expect(ofHost, `${technique}: draws of 25 by the host’s material`).toBe(25);
    expect(flushes, `${technique}: flushes under ${lights} lights`).toBe(1);
    expect(isRestored, `${technique}: three’s functions are as before`).toBe(true);
  }
});
