import { expect, test } from '../support/benchTest';

/** Lights of the figure, and how many of them cast shadows. */
const LIGHTS = 256;
const SHADOWS = 64;

/**
 * Prints the GPU's time for fog; the limit is issue 32's. By hand, on a GPU with EXT_disjoint_timer_query_webgl2:
 * `FAROL_GPU=1 FAROL_TESTS=long npm run e2e -- perf/volumetricFog --workers=1`
 */
test('fog of 256 lights, 64 of them with shadows, takes at most 1.5 ms at 1280 × 720 @gpu @long', async ({
  benchPage: page,
}) => {
  const known = await page.evaluate(
    async ([lights, shadows]) => {
      const { Bench, effects, farol, three } = window.testPage;
      await farol.FarolRenderer.preload();
      const bench = new Bench(1280, 720, { target: { type: three.HalfFloatType } });
      bench.webgl.shadowMap.enabled = true;
      const scene = new three.Scene();
      const material = new three.MeshStandardMaterial({ color: 0x808080, roughness: 0.8 });
      const floor = new three.Mesh(new three.PlaneGeometry(120, 120), material);
      floor.rotation.x = -Math.PI / 2;
      floor.receiveShadow = true;
      scene.add(floor);
      for (let i = 0; i < lights; i++) {
        const x = ((i % 16) - 7.5) * 4;
        const z = -Math.floor(i / 16) * 4;
        const color = new three.Color().setHSL((i * 0.618) % 1, 0.6, 0.6);
        const casts = i % (lights / shadows) === 0;
        const light = casts ? new three.SpotLight(color, 80, 10, 0.9, 0.5) : new three.PointLight(color, 20, 8);
        light.position.set(x, 3.5, z);
        light.castShadow = casts;
        if (light instanceof three.SpotLight) {
          light.target.position.set(x, 0, z + 0.1);
          scene.add(light.target);
        }
        const post = new three.Mesh(new three.BoxGeometry(0.4, 2, 0.4), material);
        post.position.set(x + 1, 1, z);
        post.castShadow = post.receiveShadow = true;
        scene.add(light, post);
      }
      const camera = new three.PerspectiveCamera(60, 16 / 9, 0.1, 150);
      camera.position.set(0, 2, 6);
      camera.lookAt(0, 1.5, -20);
      const fog = new effects.VolumetricFog();
      Object.assign(fog, { density: 0.03, anisotropy: 0.4, distance: 80, height: 2, falloff: 4, time: 0 });
      fog.noise = 0.5;
      bench.farol.effects = [fog];
      bench.farol.timing = true;
      const known: number[] = [];
      let frame = 0;
      while (known.length < 60) {
        fog.time = ++frame / 60;
        camera.position.x = Math.sin(frame / 30) * 0.5;
        bench.webgl.setRenderTarget(bench.target);
        bench.farol.technique = 'clustered-deferred';
        bench.farol.render(scene, camera);
        bench.webgl.setRenderTarget(null);
        await new Promise(requestAnimationFrame);
        if (!bench.farol.updateTimes() || frame < 120) continue;
        const passes = bench.farol.info.passes.filter(({ name }) => name === fog.name);
        known.push(passes.reduce((sum, { gpuMs }) => sum + (gpuMs ?? 0), 0));
      }
      return known.toSorted((a, b) => a - b);
    },
    [LIGHTS, SHADOWS] as const,
  );
  expect(known.length, 'frames with GPU times').toBeGreaterThan(10);
  const median = known[known.length >> 1];
  console.log(
    `fog, ${LIGHTS} lights, ${SHADOWS} shadows, 1280×720: ${median.toFixed(3)} ms (${known[0].toFixed(3)} to ${known.at(-1)!.toFixed(3)})`,
  );
  expect(median).toBeLessThanOrEqual(1.5);
});
