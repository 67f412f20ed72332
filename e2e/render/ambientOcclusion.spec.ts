import { expect, test } from '../support/benchTest';

const TECHNIQUES = ['deferred', 'tiled-deferred', 'clustered-deferred', 'light-prepass', 'forward-plus'] as const;
const WIDTH = 160;
const HEIGHT = 120;
/** How far off things close the sky (m). */
const RADIUS = 2;

/**
 * Share of the sky, weighted by the cosine, over a point of a plane that another plane meets at a right angle, by rays:
 * what lies nearer than `radius / √2` closes it. Beyond that the effect lets horizons sink, to none at `radius`, which on
 * a plane adds nothing to the horizon found before.
 * @param away - of the point from the other plane (m)
 */
function openSky(away: number, radius: number): number {
  const rays = 256;
  let open = 0;
  for (let i = 0; i < rays; i++) {
    for (let j = 0; j < rays; j++) {
      // a ray of the cosine-weighted hemisphere, stratified
      const towards = Math.sqrt((i + 0.5) / rays) * Math.cos((2 * Math.PI * (j + 0.5)) / rays);
      if (towards <= 0 || away / towards > radius * Math.SQRT1_2) open++;
    }
  }
  return open / rays ** 2;
}

test('two walls at a right angle close half of the sky where they meet, by every technique that knows depth', async ({
  benchPage: page,
}) => {
  const { rows, agreement, flat, half, floorSky, wallSky } = await page.evaluate(
    ([width, height, techniques, radius]) => {
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
      ao.radius = radius;
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
      /** By rows of the floor (along z) or of the wall (along y): distance from the corner (m), open share of the sky. */
      const profile = ({ open, closed }: (typeof images)[number], along: 'y' | 'z') => {
        const { position } = camera;
        const points: { away: number; share: number }[] = [];
        for (let y = 0; y < height; y++) {
          const ray = new three.Vector3(0, ((y + 0.5) / height) * 2 - 1, 0.5).unproject(camera).sub(position);
          const other = along === 'y' ? 'z' : 'y';
          const away = position[along] - (position[other] * ray[along]) / ray[other];
          let share = 0;
          for (let at = (y * width + width / 2 - 8) * 4, x = 0; x < 16; x++, at += 4)
            share += closed.data[at] / open.data[at] / 16;
          if (away > 0.15 && away < 1.3) points.push({ away, share });
        }
        return points;
      };
      const floorSky = profile(images[0], 'z');
      const agreement = images.map(({ closed }) => compareImages(images[0].closed, closed).psnr);
      // the picture turned upside down
      camera.position.set(0, 6, 3);
      camera.lookAt(0, 0, 0);
      camera.updateMatrixWorld();
      bench.farol.effects = [];
      const open = bench.byTechnique('deferred', scene, camera);
      bench.farol.effects = [ao];
      const wallSky = profile({ open, closed: bench.byTechnique('deferred', scene, camera) }, 'y');
      camera.position.set(0, 3, 6);
      camera.lookAt(0, 0, 0);
      ao.halfResolution = true;
      const half = compareImages(images[0].closed, bench.byTechnique('deferred', scene, camera)).psnr;
      ao.halfResolution = false;
      wall.visible = false;
      bench.farol.effects = [];
      const plain = bench.byTechnique('deferred', scene, camera);
      bench.farol.effects = [ao];
      const flat = compareImages(plain, bench.byTechnique('deferred', scene, camera)).psnr;
      return { rows, agreement, flat, half, floorSky, wallSky };
    },
    [WIDTH, HEIGHT, TECHNIQUES, RADIUS] as const,
  );
  rows.forEach(({ corner, above, far }, i) => {
    // a half in theory, at the very corner of endless walls
    for (const share of [corner, above]) {
      expect(share, TECHNIQUES[i]).toBeGreaterThan(0.45);
      expect(share, TECHNIQUES[i]).toBeLessThan(0.68);
    }
    expect(far, TECHNIQUES[i]).toBeGreaterThan(0.95);
  });
  expect(floorSky.length).toBeGreaterThan(8);
  expect(wallSky.length).toBe(floorSky.length);
  // the filter of 4 × 4 texels lies half a pixel up: its error has the other sign in the picture turned upside down
  for (const { away, share } of floorSky) {
    const other = wallSky.find((point) => Math.abs(point.away - away) < 1e-6)!;
    const traced = openSky(away, RADIUS);
    const error = (share + other.share) / 2 / traced - 1;
    expect.soft(Math.abs(error), `${away.toFixed(2)} m from the corner, where rays find ${traced}`).toBeLessThan(0.05);
  }
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
