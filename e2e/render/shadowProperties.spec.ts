import type { DirectionalLight, PointLight, SpotLight } from 'three';
import { expect, test } from '../support/benchTest';

type Caster = DirectionalLight | PointLight | SpotLight;

test("shadow cameras and matrices are what stock three leaves, and three's helpers and viewers show them", async ({
  benchPage: page,
}) => {
  const seen = await page.evaluate(() => {
    const { Bench, compareImages, isSlice, shadowScene, three: THREE } = window.testPage;
    const bench = new Bench(96, 72);
    const { webgl } = bench;
    webgl.shadowMap.enabled = true;
    bench.farol.technique = 'forward-single-pass';
    const results: { name: string; farol: string; stock: string }[] = [];
    /** State of each light's shadow after a frame. */
    const left = (lights: readonly Caster[]) =>
      lights.map((light) => {
        const { camera, matrix } = light.shadow;
        const { far, near, up, quaternion, position } = camera as import('three').PerspectiveCamera;
        const matrices = [camera.matrix, camera.matrixWorld, camera.matrixWorldInverse, camera.projectionMatrix, matrix]; // prettier-ignore
        const numbers = matrices.flatMap(({ elements }) => [...elements]);
        numbers.push(far, near, (camera as import('three').PerspectiveCamera).fov ?? 0, ...up, ...position, ...quaternion.toArray()); // prettier-ignore
        return numbers.map((number) => (Math.round(number * 1e5) / 1e5 + 0).toString()).join(' ');
      });
    const steps = {
      'at first': () => {},
      'moved and turned': (lights: readonly Caster[]) => {
        for (const light of lights) light.position.x += 0.5;
        (lights[0] as import('three').SpotLight).angle = 0.4;
        (lights[1] as import('three').PointLight).distance = 9;
      },
      'with other frusta': (lights: readonly Caster[]) => {
        for (const { shadow } of lights) {
          Object.assign(shadow.camera, { near: 0.7 });
          (shadow.camera as import('three').PerspectiveCamera).updateProjectionMatrix();
        }
      },
    };
    const scenes = [0, 1].map(() => shadowScene(96, 72, { caster: 'mixed', few: isSlice }));
    for (const [name, change] of Object.entries(steps)) {
      const [byFarol, byThree] = scenes.map(({ scene, camera, lights }, i) => {
        change(lights as Caster[]);
        (i === 0 ? bench.farol : webgl).render(scene, camera);
        return left(lights as Caster[]);
      });
      byFarol.forEach((farol, i) => results.push({ name: `${name}, light ${i}`, farol, stock: byThree[i] }));
    }
    // the common idiom: a helper made before anything is drawn
    const helped = (by: 'farol' | 'three') => {
      const { scene, camera, lights } = shadowScene(96, 72, { caster: 'spot', few: isSlice });
      const helper = new THREE.CameraHelper((lights[0] as Caster).shadow.camera);
      scene.add(helper);
      const draw = () => (by === 'farol' ? bench.byTechnique('deferred', scene, camera) : bench.stock(scene, camera));
      draw();
      helper.update();
      return draw();
    };
    const helper = compareImages(helped('three'), helped('farol')).psnr;
    return { results, helper };
  });
  expect(seen.results.length).toBe(15);
  for (const { name, farol, stock } of seen.results) expect.soft(farol, name).toBe(stock);
  expect(seen.helper, 'a CameraHelper (dB)').toBeGreaterThan(45);
});

test("three's ShadowMapViewer shows the maps, and stock three keeps them where the page draws them no more @verify", async ({
  benchPage: page,
}) => {
  const seen = await page.evaluate(() => {
    const { Bench, addons, compareImages, isFlat, shadowScene, three: THREE } = window.testPage;
    const results: { name: string; flat: boolean; psnr: number; moved: number; kept: number }[] = [];
    for (const type of ['PCFShadowMap', 'BasicShadowMap', 'VSMShadowMap'] as const) {
      for (const caster of ['spot', 'directional'] as const) {
        const [farol, stock] = (['farol', 'stock'] as const).map((by) => {
          const bench = new Bench(128, 72);
          const { webgl } = bench;
          Object.assign(webgl.shadowMap, { enabled: true, type: THREE[type] });
          const { scene, camera, lights } = shadowScene(128, 72, { caster });
          const viewer = new addons.ShadowMapViewer(lights[0]);
          const draw = () =>
            by === 'farol' ? bench.byTechnique('deferred', scene, camera) : bench.stock(scene, camera);
          const view = () => {
            draw();
            webgl.setRenderTarget(bench.target);
            webgl.clear();
            viewer.render(webgl);
            webgl.setRenderTarget(null);
            const data = new Float32Array(128 * 72 * 4);
            webgl.readRenderTargetPixels(bench.target, 0, 0, 128, 72, data);
            const error = webgl.getContext().getError();
            if (error !== 0) throw new Error(`${type}, ${caster}: WebGL error ${error}`);
            return { width: 128, height: 72, data };
          };
          view();
          const first = view();
          lights[0].position.x += 1.5;
          view();
          const moved = view();
          webgl.shadowMap.autoUpdate = false;
          bench.stock(scene, camera); // asks for the maps
          draw();
          const kept = bench.stock(scene, camera);
          webgl.dispose();
          bench.farol.dispose();
          return { first, moved, kept };
        });
        results.push({
          name: `${type}, ${caster}`,
          flat: isFlat(stock.first) || isFlat(farol.first),
          psnr: compareImages(stock.first, farol.first).psnr,
          moved: compareImages(stock.moved, farol.moved).psnr,
          kept: compareImages(stock.kept, farol.kept).psnr,
        });
      }
    }
    return results;
  });
  for (const { name, flat, psnr, moved, kept } of seen) {
    expect.soft(flat, `${name}: the viewer shows nothing`).toBe(false);
    expect.soft(psnr, `${name} (dB)`).toBeGreaterThan(30);
    expect.soft(moved, `${name}, moved (dB)`).toBeGreaterThan(30);
    expect.soft(kept, `${name}, drawn by stock three as they are (dB)`).toBeGreaterThan(30);
  }
});

test('a page that asks a map for its depths alone gets them, as by stock three', async ({ benchPage: page }) => {
  const maps = await page.evaluate(() => {
    const { Bench, compareImages, isFlat, shadowScene, three: THREE } = window.testPage;
    const [farol, stock] = (['farol', 'stock'] as const).map((by) => {
      const bench = new Bench(64, 48);
      const { webgl } = bench;
      Object.assign(webgl.shadowMap, { enabled: true, type: THREE.BasicShadowMap });
      const { scene, camera, lights } = shadowScene(64, 48, { caster: 'spot' });
      const map = { value: null as unknown };
      const show = new THREE.Mesh(
        new THREE.PlaneGeometry(2, 2),
        new THREE.ShaderMaterial({
          uniforms: { map },
          vertexShader: 'varying vec2 at; void main() { at = uv; gl_Position = vec4(position.xy, 0.0, 1.0); }',
          fragmentShader: `uniform highp sampler2D map; varying vec2 at;
            void main() { gl_FragColor = vec4(vec3(texture2D(map, at).r), 1.0); }`,
        }),
      );
      show.frustumCulled = false;
      const shown = new THREE.Scene().add(show);
      let picture = bench.stock(shown, camera);
      for (let i = 0; i < 2; i++) {
        if (by === 'farol') bench.byTechnique('clustered-forward', scene, camera);
        else bench.stock(scene, camera);
        map.value = (lights[0] as Caster).shadow.map!.depthTexture;
        if (i > 0) picture = bench.stock(shown, camera);
      }
      return picture;
    });
    return { flat: isFlat(stock), farol: isFlat(farol), psnr: compareImages(stock, farol).psnr };
  });
  expect(maps.flat).toBe(false);
  expect(maps.farol).toBe(false);
  expect(maps.psnr).toBeGreaterThan(30);
});
