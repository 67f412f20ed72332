import type { TechniqueName } from '@farol/renderer';
import type { EffectName } from '@farol/renderer/effects';
import { byExtent, isWhole } from '@farol/tools/extent';
import { expect, test } from '../support/test';

/**
 * Losses of the context: after each the picture is the same to the bit, without a message but of the loss itself, and with
 * no GPU object more. `npm test` loses one by one technique; `npm run losses` a hundred by each technique and effect.
 */
const LOSSES = byExtent({ slice: 1, verify: 3, long: 100 });

const LOST = /a WebGL context was lost|Context Lost|Context Restored/i;

const EFFECTS: readonly EffectName[] = ['decals', 'ambient-occlusion', 'order-independent-transparency'];
/** Techniques and effects, so that each technique and each anti-aliasing has a turn. */
const CASES: readonly (readonly [TechniqueName, readonly EffectName[]])[] = [['deferred', ['taa']]];
/** In verify; a loss under the other effects is in effects.spec.ts. */
const OTHERS: typeof CASES = [
  ['deferred', [...EFFECTS, 'taa']],
  ['inferred', ['smaa']],
  ['forward', ['order-independent-transparency', 'edges']],
  ['tiled-deferred', [...EFFECTS, 'smaa']],
  ['forward-plus', ['ambient-occlusion', 'taa']],
  ['auto', []],
  ['forward-single-pass', ['taa']],
  ['light-prepass', ['ambient-occlusion', 'edges']],
  ['tiled-forward', ['edges']],
  ['clustered-deferred', [...EFFECTS, 'edges']],
  ['clustered-forward', ['smaa']],
];

for (const [technique, effects] of isWhole ? OTHERS : CASES) {
  test(`${technique}, ${effects.join(', ')}: as before after each loss of the context`, async ({
    benchPage: page,
    watch,
  }) => {
    test.setTimeout(60_000 + 30_000 * LOSSES);
    const { changed, before, after, memory } = await page.evaluate(
      ([technique, losses, effects]) => window.testPage.loseContexts(technique, losses, effects),
      [technique, LOSSES, effects] as const,
    );
    expect(watch.forgive(LOST)).toBeGreaterThanOrEqual(LOSSES);
    expect(changed, 'losses after which the picture is another').toEqual([]);
    expect(after).toEqual(before);
    expect(memory[1]).toEqual(memory[0]);
  });
}

test('after a loss a scene without shadows is drawn right by shaders that knew some, and holds nothing of the maps that were lost @verify', async ({
  benchPage: page,
  watch,
}) => {
  const { pictures, kept, lost } = await page.evaluate(async () => {
    const { Bench, compareImages, countGpuObjects, edgeScene, shadowScene, three } = window.testPage;
    const count = countGpuObjects();
    const pictures: Record<string, number> = {};
    /** Draws what casts shadows, then what does not. @returns objects on the GPU once Farol's are disposed */
    const run = async (loses: boolean) => {
      const bench = new Bench(96, 64);
      bench.webgl.shadowMap.enabled = true;
      const shaded = shadowScene(96, 64, { caster: 'spot' });
      const freeMaps = () => {
        shaded.scene.traverse((object) => {
          const { material } = object as InstanceType<typeof three.Mesh>;
          if (material instanceof three.MeshStandardMaterial) material.map?.dispose();
        });
      };
      // as a host must
      bench.webgl.domElement.addEventListener('webglcontextlost', () => bench.target.dispose());
      bench.webgl.domElement.addEventListener('webglcontextlost', freeMaps);
      const plain = edgeScene(96, 64);
      // three's shadows and Farol's lights in one: what shows nothing but shadows
      const veil = new three.Mesh(new three.PlaneGeometry(3, 3), new three.ShadowMaterial());
      veil.position.z = 1;
      plain.scene.add(veil);
      for (let i = 0; i < 3; i++) bench.byTechnique('clustered-deferred', shaded.scene, shaded.camera);
      if (loses) await bench.loseContext();
      for (const technique of ['clustered-deferred', 'deferred', 'clustered-forward'] as const) {
        const picture = bench.byTechnique(technique, plain.scene, plain.camera);
        pictures[technique] = compareImages(bench.stock(plain.scene, plain.camera), picture).psnr;
      }
      bench.farol.dispose();
      if (!loses) freeMaps();
      const { memory } = bench.webgl.info;
      const { Texture, Framebuffer } = count();
      // of a context that is gone for good nothing counts
      const gone = new Promise((resolve) => bench.webgl.domElement.addEventListener('webglcontextlost', resolve));
      bench.webgl.getContext().getExtension('WEBGL_lose_context')!.loseContext();
      await gone;
      return { Texture, Framebuffer, textures: memory.textures };
    };
    const kept = await run(false);
    const lost = await run(true);
    return { pictures, kept, lost };
  });
  expect(watch.forgive(LOST)).toBeGreaterThanOrEqual(1);
  for (const [technique, psnr] of Object.entries(pictures)) expect(psnr, technique).toBeGreaterThan(45);
  expect(lost, 'on the GPU once Farol is disposed, and had there been no loss').toEqual(kept);
});

test('while the context is lost a technique is set and a renderer made, and both draw once it is back', async ({
  benchPage: page,
  watch,
}) => {
  const { psnr, techniques } = await page.evaluate(async () => {
    const {
      Bench,
      compareImages,
      edgeScene,
      farol: { FarolRenderer },
    } = window.testPage;
    const bench = new Bench(64, 48);
    const { webgl, farol } = bench;
    const { scene, camera } = edgeScene(64, 48);
    const stock = bench.stock(scene, camera);
    let made = farol;
    webgl.domElement.addEventListener('webglcontextlost', () => {
      bench.target.dispose();
      farol.technique = 'deferred';
      farol.view = 'albedo';
      farol.view = 'final';
      made = new FarolRenderer(webgl, { technique: 'deferred' });
    });
    await bench.loseContext();
    const pictures = [farol, made].map((each) => bench.draw(() => each.render(scene, camera)));
    return {
      psnr: pictures.map((picture) => compareImages(stock, picture).psnr),
      techniques: [farol.info.technique, made.info.technique],
    };
  });
  expect(watch.forgive(LOST)).toBeGreaterThanOrEqual(1);
  expect(techniques).toEqual(['deferred', 'deferred']);
  for (const each of psnr) expect(each).toBeGreaterThan(45);
});
