import type { TechniqueName } from '@farol/renderer';
import { extent } from '@farol/tools/extent';
import type { Page } from '@playwright/test';
import { checkAgreement } from '../support/agreement';
import type { Difference } from '../support/images';
import { expect, test } from '../support/test';

// the layer of the emulated headset is as large as the window
test.use({ viewport: { width: 192, height: 96 } });

async function open(page: Page, pagesURL: string): Promise<void> {
  await page.goto(`${pagesURL}xr.html?tests=${extent}`);
  await page.waitForFunction(() => 'xrPage' in window);
}

test('each eye is the picture of stock three, in a rig that moves, with lights and things of one eye', async ({
  page,
  pagesURL,
}) => {
  await open(page, pagesURL);
  const results = await page.evaluate(async () => {
    const { XRBench, compareImages, device, eyeOf, isFlat, isSlice, shadowScene, techniquesInTurn, three } =
      window.xrPage;
    const bench = new XRBench();
    const { farol, webgl } = bench;
    farol.inferredScale = 1;
    await bench.start('immersive-vr');
    const { scene } = shadowScene(96, 96, { caster: 'mixed', few: isSlice });
    const camera = new three.PerspectiveCamera(50, 1, 0.1, 60);
    const rig = new three.Group();
    rig.position.set(0.5, 0.3, 5);
    rig.rotation.set(0, 0.2, 0.1);
    rig.add(camera);
    scene.add(rig);
    device.position.set(0.1, 1.5, 0.2);
    device.quaternion.set(-0.1, 0.05, 0, Math.sqrt(1 - 0.0125));
    device.ipd = 0.3;
    for (const [i, x] of [-0.5, 0.5].entries()) {
      const ball = new three.Mesh(new three.SphereGeometry(0.3), new three.MeshStandardMaterial({ color: 0xff8844 }));
      ball.position.set(x, 1.6, 2);
      ball.layers.set(i + 1);
      scene.add(ball);
    }
    const found: (Difference & { technique: TechniqueName; drawn: string; eye: number; flat: boolean })[] = [];
    for (const technique of techniquesInTurn(4)) {
      await bench.settle(technique, scene, camera);
      const [stock, ours] = await bench.frame(() => [
        bench.floats(() => webgl.render(scene, camera)),
        bench.floats(() => farol.render(scene, camera)),
      ]);
      for (const eye of [0, 1] as const) {
        const seen = eyeOf(stock, eye);
        const drawn = farol.info.technique;
        found.push({ technique, drawn, eye, flat: isFlat(seen), ...compareImages(seen, eyeOf(ours, eye)) });
      }
    }
    await bench.end();
    return found;
  });
  for (const { technique, drawn, eye, flat, ...difference } of results) {
    expect(flat).toBe(false);
    expect(drawn).toBe(technique === 'auto' ? 'clustered-forward' : technique);
    checkAgreement(drawn, difference, `eye ${eye}, ${technique}`);
  }
});

test('shadow maps are drawn once, with the first eye, for lights that any eye sees', async ({ page, pagesURL }) => {
  await open(page, pagesURL);
  const { casts, stockCasts, passes, difference } = await page.evaluate(async () => {
    const { XRBench, compareImages, device, isSlice, shadowScene, three } = window.xrPage;
    const bench = new XRBench();
    const { farol, webgl } = bench;
    webgl.shadowMap.enabled = true;
    await bench.start('immersive-vr');
    const { scene } = shadowScene(96, 96, { caster: 'mixed', few: isSlice });
    const camera = new three.PerspectiveCamera(50, 1, 0.1, 60);
    const rig = new three.Group();
    rig.position.z = 5;
    rig.add(camera);
    scene.add(rig);
    device.ipd = 12;
    // a lamp over a post at each side, seen by one eye alone
    for (const x of [-6, 6]) {
      const post = new three.Mesh(new three.BoxGeometry(1.2, 1, 1.2), new three.MeshStandardMaterial());
      post.position.set(x, 0.5, 0);
      post.castShadow = true;
      const lamp = new three.SpotLight(0xffffff, 200, 3, 1, 0.3);
      lamp.position.set(x, 2.4, 0.5);
      lamp.target.position.set(x, 0, 0);
      lamp.castShadow = true;
      scene.add(post, lamp, lamp.target);
    }
    const spinner = new three.Mesh(new three.BoxGeometry(5, 1, 1), new three.MeshStandardMaterial());
    spinner.position.y = 1.5;
    spinner.castShadow = true;
    let casts = 0;
    spinner.onBeforeShadow = () => casts++;
    scene.add(spinner);
    await bench.settle('clustered-forward', scene, camera);
    return bench.frame(() => {
      spinner.rotation.y = 0.5;
      casts = 0;
      const ours = bench.floats(() => farol.render(scene, camera));
      const drawn = casts;
      const passes = farol.info.passes.map(({ name }) => name);
      casts = 0;
      const stock = bench.floats(() => webgl.render(scene, camera));
      return { casts: drawn, stockCasts: casts, passes, difference: compareImages(stock, ours) };
    });
  });
  expect(casts).toBeGreaterThan(0);
  expect(casts).toBe(stockCasts);
  expect(passes.filter((name) => name.startsWith('shadow maps'))).toHaveLength(1);
  expect(passes).toContain('opaque, eye 2');
  checkAgreement('clustered-forward', difference, 'shadows in XR', { largest: Infinity, psnr: 55, share: 0.001 });
});

test('passthrough shows where nothing is drawn, by the alpha of stock three', async ({ page, pagesURL }) => {
  await open(page, pagesURL);
  const results = await page.evaluate(async () => {
    const { XRBench, compareImages, effects, isSlice, shadowScene, three } = window.xrPage;
    const bench = new XRBench({ alpha: true });
    const { farol, webgl } = bench;
    await bench.start('immersive-ar');
    const { scene } = shadowScene(96, 96, { caster: 'mixed', few: isSlice });
    const camera = new three.PerspectiveCamera();
    const rig = new three.Group();
    rig.position.z = 10;
    rig.add(camera);
    scene.add(rig);
    const results = [];
    for (const technique of ['clustered-forward', 'tiled-deferred'] as const) {
      for (const smooth of [false, true]) {
        farol.effects = smooth ? [new effects.SMAA()] : [];
        await bench.settle(technique, scene, camera);
        const [stock, ours] = await bench.frame(() => [
          bench.layer(() => webgl.render(scene, camera)),
          bench.layer(() => farol.render(scene, camera)),
        ]);
        const empty = stock.data.filter((value, i) => i % 4 === 3 && value === 0).length;
        results.push({ technique, smooth, empty, ...compareImages(stock, ours) });
      }
    }
    return results;
  });
  for (const { technique, smooth, empty, alpha, share } of results) {
    const name = `${technique}, smooth: ${smooth}`;
    expect(empty, name).toBeGreaterThan(100);
    if (smooth) continue;
    expect(alpha, name).toBe(0);
    expect(share, name).toBeLessThan(0.001);
  }
  // smoothed edges differ: as many as lie between a thing and nothing
  for (const { technique, share } of results.filter(({ smooth }) => smooth))
    expect(share, technique).toBeLessThan(0.06);
});

test('effects draw each eye as a picture of its own; what gathers frames is left out with a warning', async ({
  page,
  pagesURL,
  watch,
}) => {
  await open(page, pagesURL);
  const results = await page.evaluate(async () => {
    const { XRBench, compareImages, effects, eyeOf, isSlice, shadowScene, three } = window.xrPage;
    const bench = new XRBench();
    const { farol, webgl } = bench;
    await bench.start('immersive-vr');
    const { scene } = shadowScene(96, 96, { caster: 'mixed', few: isSlice });
    scene.add(new three.AmbientLight(0xffffff, 2));
    const camera = new three.PerspectiveCamera();
    farol.effects = [new effects.AmbientOcclusion(), new effects.SMAA(), new effects.TAA()];
    await bench.settle('auto', scene, camera);
    const { technique } = farol.info;
    const [both, ...eyes] = await bench.frame(() => {
      const both = bench.layer(() => farol.render(scene, camera));
      farol.effects = farol.effects.slice(0, 2);
      farol.technique = 'clustered-deferred';
      const { cameras } = webgl.xr.getCamera();
      webgl.xr.enabled = false;
      // each eye as the only camera of its half, by an array that is none of a session
      const eyes = cameras.map((eye) => {
        const array = new three.ArrayCamera([eye]);
        array.copy(eye, false);
        array.cameras = [eye];
        return bench.layer(() => farol.render(scene, array));
      });
      webgl.xr.enabled = true;
      farol.effects = [];
      return [both, ...eyes, bench.layer(() => farol.render(scene, camera))];
    });
    const plain = eyes.pop()!;
    const compare = (i: 0 | 1) => compareImages(eyeOf(eyes[i], i), eyeOf(both, i)).largest;
    return { technique, differences: [compare(0), compare(1)], gain: compareImages(plain, both).largest };
  });
  expect(watch.forgive(/TAA is left out, since it gathers frames of one camera/)).toBe(1);
  expect(results.technique).toBe('clustered-deferred');
  expect(results.differences).toEqual([0, 0]);
  expect(results.gain).toBeGreaterThan(0.02);
});

test('a context that is lost in a session again and again shows the same picture, and each time all of Farol on the GPU is let go of @verify', async ({
  page,
  pagesURL,
  watch,
}) => {
  test.setTimeout(180_000);
  await open(page, pagesURL);
  const losses = 20;
  const { stock, farol, changed, errors } = await page.evaluate(async (losses) => {
    const { XRBench, countGpuObjects, effects, isSlice, shadowScene, three } = window.xrPage;
    const count = countGpuObjects(true);
    /** Draws after each loss. @returns objects that each loss has left behind, by kind */
    const run = async (losses: number, byFarol: boolean) => {
      const bench = new XRBench();
      const { farol, webgl } = bench;
      const { domElement } = webgl;
      webgl.shadowMap.enabled = true;
      await bench.start('immersive-vr');
      const { scene } = shadowScene(96, 96, { caster: 'mixed', few: isSlice });
      const camera = new three.PerspectiveCamera();
      // the host's own things are the host's to free
      domElement.addEventListener('webglcontextlost', () =>
        scene.traverse((object) => {
          const { geometry, material, shadow } = object as Partial<
            InstanceType<typeof three.Mesh> & InstanceType<typeof three.SpotLight>
          >;
          geometry?.dispose();
          for (const each of [material ?? []].flat()) {
            for (const value of Object.values(each)) if (value instanceof three.Texture) value.dispose();
            each.dispose();
          }
          shadow?.dispose();
        }),
      );
      farol.effects = [new effects.AmbientOcclusion(), new effects.SMAA()];
      const draw = async () => {
        if (byFarol) await bench.settle('clustered-deferred', scene, camera);
        return bench.frame(() =>
          bench.layer(() => (byFarol ? farol.render(scene, camera) : webgl.render(scene, camera))),
        );
      };
      const first = await draw();
      const changed: number[] = [];
      const left: Record<string, number>[] = [];
      for (let loss = 1, before = count(); loss <= losses; loss++) {
        await bench.loseContext();
        const { data } = await draw();
        if (data.some((value, i) => value !== first.data[i])) changed.push(loss);
        const after = count();
        left.push(Object.fromEntries(Object.entries(after).map(([kind, n]) => [kind, n - (before[kind] ?? 0)])));
        before = after;
      }
      const error = webgl.getContext().getError();
      await bench.end();
      return { left, changed, error };
    };
    // what three holds of a lost context for itself, besides programs of shadow maps
    const [, stock] = (await run(2, false)).left;
    const { left, changed, error } = await run(losses, true);
    return { stock, farol: left, changed, errors: error };
  }, losses);
  // the emulator clears its framebuffer whether or not there is a context
  watch.forgive(/context|at onDeviceFrame/i);
  expect(changed).toEqual([]);
  expect(errors).toBe(0);
  expect(farol).toHaveLength(losses);
  // what the first frames drew by before all code was there is gone with the first loss
  for (const [i, left] of farol.slice(1).entries()) expect(left, `loss ${i + 2}`).toEqual({ ...stock, Program: 0 });
});
