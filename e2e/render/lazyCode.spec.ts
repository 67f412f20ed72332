import { extent } from '@farol/tools/extent';
import { expect, test } from '../support/test';

/** Techniques that draw before the code of others is there: those that have drawn the scene before. */
const instead: Readonly<Record<string, string>> = {
  'before, light-prepass': 'deferred',
  'before, clustered-forward': 'deferred',
  'before, tiled-deferred': 'deferred',
};

test('before lazy code is there three draws the shadows and deferred shading the rest, then Farol does: the same picture', async ({
  page,
  pagesURL,
}) => {
  await page.goto(`${pagesURL}?lazy`);
  await page.waitForFunction(() => 'testPage' in window);
  const seen = await page.evaluate(async () => {
    const { Bench, compareImages, farol, three: THREE } = window.testPage;
    const bench = new Bench(96, 72);
    bench.webgl.shadowMap.enabled = true;
    const scene = new THREE.Scene();
    const floor = new THREE.Mesh(new THREE.PlaneGeometry(8, 8), new THREE.MeshStandardMaterial());
    floor.rotation.x = -Math.PI / 2;
    floor.receiveShadow = true;
    const box = new THREE.Mesh(new THREE.BoxGeometry(1, 2, 1), new THREE.MeshStandardMaterial({ color: 0xcc5522 }));
    box.position.y = 1;
    box.castShadow = true;
    const light = new THREE.SpotLight(0xffffff, 200, 20, 0.6, 0.3);
    light.position.set(3, 5, 2);
    light.castShadow = true;
    scene.add(floor, box, light, new THREE.PointLight(0x4466ff, 10, 6).translateY(3).translateX(-2));
    const camera = new THREE.PerspectiveCamera(50, 96 / 72, 0.1, 30);
    camera.position.set(2, 4, 7);
    camera.lookAt(0, 0.5, 0);
    const stock = bench.stock(scene, camera);
    light.castShadow = false;
    const without = compareImages(stock, bench.stock(scene, camera)).psnr;
    light.castShadow = true;
    const techniques = [
      'forward-single-pass',
      'deferred',
      'light-prepass',
      'clustered-forward',
      'tiled-deferred',
    ] as const;
    const result: { without: number; frames: [string, number, number, string][] } = { without, frames: [] };
    for (const when of ['before', 'after']) {
      if (when === 'after') await farol.FarolRenderer.preload();
      for (const technique of techniques) {
        const { psnr } = compareImages(stock, bench.byTechnique(technique, scene, camera));
        result.frames.push([
          `${when}, ${technique}`,
          psnr,
          bench.farol.info.shadows.drawn + bench.farol.info.shadows.kept,
          bench.farol.info.technique,
        ]);
      }
    }
    return result;
  });
  expect(seen.without, 'a picture without the shadow').toBeLessThan(35);
  for (const [name, psnr, maps, technique] of seen.frames) {
    expect(psnr, name).toBeGreaterThan(45);
    expect(maps, name).toBe(name.startsWith('before') ? 0 : 1);
    expect(technique, name).toBe(instead[name] ?? name.split(', ')[1]);
  }
});

test('where lights are many, deferred shading draws until the code of light lists is there', async ({
  page,
  pagesURL,
}) => {
  await page.goto(`${pagesURL}?lazy`);
  await page.waitForFunction(() => 'testPage' in window);
  const drawnBy = await page.evaluate(() => {
    const { Bench, three: THREE } = window.testPage;
    const bench = new Bench(8, 8);
    const camera = new THREE.PerspectiveCamera(50, 1, 0.1, 30);
    camera.position.z = 5;
    return [16, 17].map((lights) => {
      const scene = new THREE.Scene();
      for (let i = 0; i < lights; i++) scene.add(new THREE.PointLight(0xffffff, 1, 5));
      bench.byTechnique('clustered-forward', scene, camera);
      return bench.farol.info.technique;
    });
  });
  expect(drawnBy).toEqual(['forward-single-pass', 'deferred']);
});

test('a page that was offline gets its shadows when it is online again, with one warning meanwhile, and ready says so', async ({
  page,
  pagesURL,
  watch,
}) => {
  await page.goto(`${pagesURL}?lazy`);
  await page.waitForFunction(() => 'testPage' in window);
  await page.evaluate(async () => {
    const { Bench, farol, shadowScene } = window.testPage;
    const bench = new Bench(64, 48);
    bench.webgl.shadowMap.enabled = true;
    const { scene, camera } = shadowScene(64, 48, { caster: 'spot', few: true });
    await farol.FarolRenderer.preload(['warm-up']);
    const maps = () => {
      bench.byTechnique('forward-single-pass', scene, camera);
      const { drawn, kept } = bench.farol.info.shadows;
      return drawn + kept;
    };
    const ready = () =>
      bench.farol.ready.then(
        () => 'ready',
        (error: Error) => error.message,
      );
    Object.assign(window, { maps, ready });
  });
  const maps = () => page.evaluate(() => (window as unknown as { maps(): number }).maps());
  const ready = () => page.evaluate(() => (window as unknown as { ready(): Promise<string> }).ready());
  await page.context().setOffline(true);
  expect(await maps()).toBe(0);
  await expect.poll(() => watch.problems.filter((problem) => problem.includes('the code of shadows')).length).toBe(1);
  expect(await maps()).toBe(0);
  expect(await ready()).toMatch(/the code of shadows cannot be fetched.*Serve the files of @farol\/renderer together/);
  await page.context().setOffline(false);
  await expect.poll(maps).toBe(2);
  expect(await ready()).toBe('ready');
  watch.forgive(/ERR_INTERNET_DISCONNECTED/);
  expect(watch.forgive(/console warning: Farol: the code of shadows cannot be fetched; .* three draws shadows/)).toBe(
    1,
  );
});

test('ready waits for the first frame, and for one after a lost context; a renderer that is disposed rejects it', async ({
  benchPage: page,
  watch,
}) => {
  const seen = await page.evaluate(async () => {
    const { Bench, shadowScene } = window.testPage;
    const bench = new Bench(32, 24);
    const { farol } = bench;
    const { scene, camera } = shadowScene(32, 24, { caster: 'spot', few: true });
    const draw = () => bench.byTechnique('deferred', scene, camera);
    const steps: string[] = [];
    const wait = (name: string) =>
      farol.ready.then(
        () => steps.push(`${name}: ready`),
        (error: Error) => steps.push(`${name}: ${error.message}`),
      );
    const first = wait('first');
    steps.push('draws');
    draw();
    await first;
    await wait('at rest');
    await bench.loseContext();
    const restored = wait('restored');
    steps.push('draws again');
    draw();
    await restored;
    farol.dispose();
    await wait('disposed');
    return steps;
  });
  expect(watch.forgive(/a WebGL context was lost|Context Lost|Context Restored/i)).toBeGreaterThan(0);
  expect(seen).toEqual([
    'draws',
    'first: ready',
    'at rest: ready',
    'draws again',
    'restored: ready',
    'disposed: Farol: the renderer was disposed before it was ready; make a new FarolRenderer.',
  ]);
});

test('a picture without a field, and its programs, are the same before and after the code of fields came', async ({
  page,
  pagesURL,
}) => {
  await page.goto(`${pagesURL}?lazy&tests=${extent}`);
  await page.waitForFunction(() => 'testPage' in window);
  const seen = await page.evaluate(async () => {
    const { Bench, farol, isSlice, lightFields, three } = window.testPage;
    const scene = new three.Scene();
    const floor = new three.Mesh(new three.PlaneGeometry(9, 9), new three.MeshStandardMaterial({ roughness: 0.4 }));
    const glass = new three.Mesh(
      new three.SphereGeometry(0.7, 12, 8),
      new three.MeshPhongMaterial({ transparent: true, opacity: 0.5 }),
    );
    glass.position.z = 0.8;
    scene.add(floor, glass, new three.HemisphereLight(0x334455, 0x221100, 0.5));
    for (let i = 0; i < 60; i++) {
      const light = i % 3 ? new three.PointLight(0xffddaa, 0.5, 2) : new three.SpotLight(0xaaddff, 2, 3, 0.5, 0.5);
      light.position.set((i % 10) - 4.5, Math.floor(i / 10) - 2.5, 0.8);
      if ('target' in light) {
        light.target.position.set(light.position.x, light.position.y, 0);
        scene.add(light.target);
      }
      scene.add(light);
    }
    const camera = new three.PerspectiveCamera(50, 4 / 3, 0.1, 20);
    camera.position.set(0, -2, 6);
    camera.lookAt(0, 0, 0);
    // what needs code of another kind is left out, or its code fetched: it would change with that
    await farol.FarolRenderer.preload(['light-grid', 'light-tiles']);
    const all = ['forward-single-pass', 'tiled-deferred', 'clustered-forward', 'deferred', 'clustered-deferred'];
    const techniques = isSlice ? all.slice(0, 3) : all;
    const draw = () => {
      const bench = new Bench(64, 48);
      const gl = bench.webgl.getContext() as WebGL2RenderingContext;
      const pictures = techniques.map((technique) => [
        ...bench.byTechnique(technique as 'forward', scene, camera).data,
      ]);
      const sources = (bench.webgl.info.programs ?? [])
        .flatMap(({ program }) => gl.getAttachedShaders(program as WebGLProgram) ?? [])
        .map((shader) => gl.getShaderSource(shader));
      const again = (change: () => void) => {
        change();
        return techniques.map((technique) => [...bench.byTechnique(technique as 'forward', scene, camera).data]);
      };
      return { pictures, sources: sources.toSorted(), again };
    };
    const before = draw();
    const { pictures } = before;
    await farol.FarolRenderer.preload();
    const after = draw();
    const field = new lightFields.LightField(200);
    for (let i = 0; i < 200; i++) field.setPoint(i, (i % 20) / 2 - 5, Math.floor(i / 20) - 5, 0.5, 1, 1, 0, 1);
    const withField = before.again(() => scene.add(field));
    const without = before.again(() => scene.remove(field));
    return {
      sources: [before.sources.length, JSON.stringify(after.sources) === JSON.stringify(before.sources)],
      same: [after.pictures, without].map((list) => JSON.stringify(list) === JSON.stringify(pictures)),
      seen: withField.map((picture, i) => JSON.stringify(picture) !== JSON.stringify(pictures[i])),
    };
  });
  expect(seen.sources[0]).toBeGreaterThan(8);
  expect(seen.sources[1], 'sources of programs').toBe(true);
  expect(seen.same, 'another renderer, and one that drew a field').toEqual([true, true]);
  expect(seen.seen.length).toBeGreaterThan(2);
  expect(seen.seen, 'techniques that show the field').not.toContain(false);
});
