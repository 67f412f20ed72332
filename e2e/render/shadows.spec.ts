import { expect, test } from '../support/test';

/**
 * Shadows against stock three, in linear float. Forward techniques run three's own filters: what differs are the seams of
 * point lights' cube maps, which three filters across its own faces and Farol across a border of one texel. Techniques with
 * a G-buffer rebuild positions, so that pixels at the edge of a texel may fall on its other side (`basic` has hard edges);
 * inferred lighting smooths what changes from pixel to pixel.
 */
const WIDTH = 128;
const HEIGHT = 96;

test.beforeEach(async ({ page, pagesURL }) => {
  await page.goto(pagesURL);
  await page.waitForFunction(() => 'testPage' in window);
});

// three has no variance shadow maps of point lights, and warns of it
const types = { basic: 0, pcf: 1, vsm: 3 } as const;

for (const type of Object.keys(types) as (keyof typeof types)[]) {
  test(`${type} shadows of each kind of light: as in stock three`, async ({ page }) => {
    const seen = await page.evaluate(
      ([width, height, type]) => {
        const { Bench, compareImages, shadowScene } = window.testPage;
        const bench = new Bench(width, height);
        bench.webgl.shadowMap.enabled = true;
        bench.webgl.shadowMap.type = type;
        return (['spot', 'point', 'directional'] as const)
          .filter((caster) => type !== 3 || caster !== 'point')
          .map((caster) => {
            const { scene, camera, lights } = shadowScene(width, height, { caster });
            const stock = bench.stock(scene, camera);
            for (const light of lights) light.castShadow = false;
            const without = bench.byTechnique('forward-single-pass', scene, camera);
            for (const light of lights) light.castShadow = true;
            return {
              caster,
              matters: compareImages(stock, without).psnr,
              pairs: (['forward-single-pass', 'deferred'] as const).map((technique) => ({
                technique,
                ...compareImages(stock, bench.byTechnique(technique, scene, camera)),
              })),
            };
          });
      },
      [WIDTH, HEIGHT, types[type]] as const,
    );
    for (const { caster, matters, pairs } of seen) {
      expect(matters, `${caster}: the shadows are to be seen`).toBeLessThan(32);
      for (const { technique, psnr, share } of pairs) {
        const said = `${caster}, ${technique}: ${psnr.toFixed(1)} dB, ${(share * 100).toFixed(2)}% off by more than 2/255`;
        test.info().annotations.push({ type: 'agreement', description: said });
        expect(psnr, said).toBeGreaterThanOrEqual(45);
      }
    }
  });
}

test('shadows of all kinds of light at once, by every technique', async ({ page }) => {
  test.setTimeout(180_000);
  const pairs = await page.evaluate(
    ([width, height]) => {
      const { Bench, compareImages, farol, shadowScene } = window.testPage;
      const bench = new Bench(width, height);
      bench.webgl.shadowMap.enabled = true;
      const { scene, camera } = shadowScene(width, height, { caster: 'mixed' });
      const stock = bench.stock(scene, camera);
      return (Object.keys(farol.techniques) as (keyof typeof farol.techniques)[]).map((technique) => ({
        technique,
        ...compareImages(stock, bench.byTechnique(technique, scene, camera)),
      }));
    },
    [WIDTH, HEIGHT] as const,
  );
  for (const { technique, psnr, share } of pairs) {
    const said = `${technique}: ${psnr.toFixed(1)} dB, ${(share * 100).toFixed(2)}% off by more than 2/255`;
    test.info().annotations.push({ type: 'agreement', description: said });
    expect(psnr, said).toBeGreaterThanOrEqual(technique === 'inferred' ? 30 : 45);
  }
});

test('cookies: a spot light throws its map as in stock three, with and without shadows, and a point light its cube', async ({
  page,
}) => {
  const { pairs, cube } = await page.evaluate(
    ([width, height]) => {
      const { Bench, compareImages, shadowScene, three, farol } = window.testPage;
      const bench = new Bench(width, height);
      bench.webgl.shadowMap.enabled = true;
      const image = (hue: number) => {
        const data = new Uint8Array(16 * 16 * 4);
        for (let i = 0; i < 256; i++) {
          const [x, y] = [i % 16, Math.floor(i / 16)];
          data.set([40 + x * 13, 255 - y * 14, hue, 255], i * 4);
        }
        return data;
      };
      const map = new three.DataTexture(image(90), 16, 16);
      map.colorSpace = three.SRGBColorSpace;
      map.magFilter = map.minFilter = three.LinearFilter;
      map.needsUpdate = true;
      const { scene, camera, lights } = shadowScene(width, height, { caster: 'spot', map });
      const compare = (name: string) => {
        const stock = bench.stock(scene, camera);
        return (['forward-single-pass', 'deferred', 'tiled-deferred'] as const).map((technique) => ({
          name: `${name}, ${technique}`,
          ...compareImages(stock, bench.byTechnique(technique, scene, camera)),
        }));
      };
      const both = compare('map and shadow');
      lights[0].castShadow = false;
      const one = compare('map, one light without shadow');
      // white on all sides but one is the same as no cookie, but for that side
      const room = shadowScene(width, height, { caster: 'point' });
      const plain = bench.byTechnique('deferred', room.scene, room.camera);
      const face = (value: number) =>
        Object.assign(new three.DataTexture(new Uint8Array(16).fill(value), 2, 2), { needsUpdate: true });
      const black = [0, 1, 2, 3, 4, 5].map((i) => face(i === 3 ? 0 : 255)); // -y, the floor below the lights
      const cookie = new three.CubeTexture(black as unknown as HTMLImageElement[]);
      cookie.needsUpdate = true;
      for (const light of room.lights) farol.setLightCookie(light as InstanceType<typeof three.PointLight>, cookie);
      const dark = bench.byTechnique('deferred', room.scene, room.camera);
      const at = (data: Float32Array, x: number, y: number) =>
        data[4 * (Math.floor(y * height) * width + Math.floor(x * width))];
      return {
        pairs: [...both, ...one],
        cube: {
          wall: [at(plain.data, 0.5, 0.9), at(dark.data, 0.5, 0.9)],
          floor: [at(plain.data, 0.5, 0.1), at(dark.data, 0.5, 0.1)],
        },
      };
    },
    [WIDTH, HEIGHT] as const,
  );
  for (const { name, psnr } of pairs) expect(psnr, name).toBeGreaterThanOrEqual(45);
  expect(cube.wall[1], 'the wall is lit as before').toBeCloseTo(cube.wall[0], 3);
  expect(cube.floor[1], 'the floor is dark').toBeLessThan(0.3 * cube.floor[0]);
});
