import { expect, test } from '../support/benchTest';

const TECHNIQUES = ['deferred', 'tiled-deferred', 'clustered-deferred', 'light-prepass', 'forward-plus'] as const;
const WIDTH = 160;
const HEIGHT = 120;

test('two walls at a right angle close half of the sky where they meet, by every technique that knows depth', async ({
  benchPage: page,
}) => {
  const { rows, agreement, flat, half } = await page.evaluate(
    ([width, height, techniques]) => {
      const { Bench, compareImages, effects, three } = window.testPage;
      const scene = new three.Scene();
      const material = new three.MeshStandardMaterial({ roughness: 1 });
      const floor = new three.Mesh(new three.PlaneGeometry(40, 40), material);
      floor.rotation.x = -Math.PI / 2;
      const wall = new three.Mesh(new three.PlaneGeometry(40, 40), material);
      scene.add(floor, wall, new three.AmbientLight(0xffffff, 1));
      const camera = new three.PerspectiveCamera(60, width / height, 0.1, 100);
      camera.position.set(0, 3, 6);
      camera.lookAt(0, 0, 0);
      const bench = new Bench(width, height);
      const ao = new effects.AmbientOcclusion();
      ao.radius = 2;
      const images = techniques.map((technique) => {
        bench.farol.effects = [];
        const open = bench.byTechnique(technique, scene, camera);
        bench.farol.effects = [ao];
        const closed = bench.byTechnique(technique, scene, camera);
        return { open, closed };
      });
      // the share of light that is left, in the middle of a row
      const share = (i: number, y: number) => {
        const at = (y * width + width / 2) * 4;
        return images[i].closed.data[at] / images[i].open.data[at];
      };
      const corner = new three.Vector3(0, 0, 0).project(camera);
      const row = Math.round((corner.y * 0.5 + 0.5) * height);
      const rows = techniques.map((_, i) => ({
        corner: share(i, row - 2),
        above: share(i, row + 2),
        far: share(i, 6),
      }));
      const agreement = images.map(({ closed }) => compareImages(images[0].closed, closed).psnr);
      ao.halfResolution = true;
      const half = compareImages(images[0].closed, bench.byTechnique('deferred', scene, camera)).psnr;
      ao.halfResolution = false;
      wall.visible = false;
      bench.farol.effects = [];
      const plain = bench.byTechnique('deferred', scene, camera);
      bench.farol.effects = [ao];
      const flat = compareImages(plain, bench.byTechnique('deferred', scene, camera)).psnr;
      return { rows, agreement, flat, half };
    },
    [WIDTH, HEIGHT, TECHNIQUES] as const,
  );
  rows.forEach(({ corner, above, far }, i) => {
    // a half in theory, at the very corner of endless walls
    for (const share of [corner, above]) {
      expect(share, TECHNIQUES[i]).toBeGreaterThan(0.45);
      expect(share, TECHNIQUES[i]).toBeLessThan(0.68);
    }
    expect(far, TECHNIQUES[i]).toBeGreaterThan(0.95);
  });
  agreement.forEach((psnr, i) => expect(psnr, `${TECHNIQUES[i]} as deferred`).toBeGreaterThan(45));
  expect(half, 'half the resolution').toBeGreaterThan(40);
  expect(flat, 'a plane alone stays light').toBeGreaterThan(44);
});

test('direct and emissive light stay as they are; materials under indirect light are all taken down', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(
    ([width, height, techniques]) => {
      const { Bench, compareImages, edgeScene, effects, three } = window.testPage;
      const bench = new Bench(width, height);
      const { scene, camera } = edgeScene(width, height);
      scene.background = null;
      scene.traverse((object) => {
        const { material } = object as InstanceType<typeof three.Mesh>;
        if (material instanceof three.MeshStandardMaterial) material.emissive.set(0.05, 0, 0.1);
      });
      const ambient = scene.children.filter((child) => (child as { isAmbientLight?: boolean }).isAmbientLight);
      const ao = new effects.AmbientOcclusion();
      const draw = (technique: (typeof techniques)[number], list: (typeof ao)[]) => {
        bench.farol.effects = list;
        return bench.byTechnique(technique, scene, camera);
      };
      const light = ({ data }: { data: Float32Array }) =>
        data.reduce((sum, value, i) => (i % 4 < 3 ? sum + value : sum), 0);
      return techniques.map((technique) => {
        for (const one of ambient) one.visible = false;
        const direct = compareImages(draw(technique, []), draw(technique, [ao])).largest;
        for (const one of ambient) one.visible = true;
        (ambient[0] as InstanceType<typeof three.AmbientLight>).intensity = 3;
        return { technique, direct, left: light(draw(technique, [ao])) / light(draw(technique, [])) };
      });
    },
    [WIDTH, HEIGHT, TECHNIQUES] as const,
  );
  for (const { technique, direct, left } of results) {
    expect(direct, technique).toBeLessThan(2e-3);
    expect(left, technique).toBeGreaterThan(0.8);
    expect(left, technique).toBeLessThan(0.996);
  }
});

test('a technique that knows no depth says so once, and draws as without', async ({ benchPage: page, watch }) => {
  const same = await page.evaluate(() => {
    const { Bench, compareImages, edgeScene, effects } = window.testPage;
    const bench = new Bench(64, 48);
    const { scene, camera } = edgeScene(64, 48);
    const without = bench.byTechnique('clustered-forward', scene, camera);
    bench.farol.effects = [new effects.AmbientOcclusion()];
    bench.byTechnique('auto', scene, camera); // has nothing to say: it picks a technique that knows depth
    if (bench.farol.info.technique !== 'clustered-deferred')
      throw new Error(`auto picks ${bench.farol.info.technique}`);
    bench.byTechnique('clustered-forward', scene, camera);
    return compareImages(without, bench.byTechnique('clustered-forward', scene, camera)).largest;
  });
  expect(same).toBe(0);
  expect(watch.forgive(/ambient occlusion is left out.*use 'deferred'/)).toBe(1);
});
