import { expectAsMeasured } from '../support/agreement';
import { expect, test } from '../support/benchTest';

/**
 * Shadows against stock three, in linear float. Forward techniques run three's own filters: what differs are the seams of
 * point lights' cube maps, which three filters across its own faces and Farol across a border round each. Techniques with
 * a G-buffer rebuild positions, so that pixels at the edge of a texel may fall on its other side (`basic` has hard edges);
 * inferred lighting smooths what changes from pixel to pixel.
 */
const WIDTH = 128;
const HEIGHT = 96;

// three has no variance shadow maps of point lights, and warns of it
const types = { basic: 0, pcf: 1, vsm: 3 } as const;

/** Measured by forward-single-pass and by deferred (dB). */
const measured: Record<string, readonly [number, number]> = {
  'basic, spot': [60, 46.4],
  'basic, point': [52.7, 51],
  'basic, directional': [54.1, 46],
  'pcf, spot': [70.5, 64.5],
  'pcf, point': [58.6, 56.9],
  'pcf, point, radius 6': [58.9, 57.5],
  'pcf, directional': [64.7, 60.9],
  'vsm, spot': [69, 63.8],
  'vsm, directional': [108.7, 63.3],
};

for (const type of Object.keys(types) as (keyof typeof types)[]) {
  test(`${type} shadows of each kind of light: as in stock three`, async ({ benchPage: page }) => {
    const seen = await page.evaluate(
      ([width, height, type]) => {
        const { Bench, compareImages, shadowScene } = window.testPage;
        const bench = new Bench(width, height);
        bench.webgl.shadowMap.enabled = true;
        bench.webgl.shadowMap.type = type;
        const cases = [
          { name: 'spot', caster: 'spot' },
          { name: 'point', caster: 'point' },
          // wide enough to cross the edges of the cube's faces
          { name: 'point, radius 6', caster: 'point', settings: { radius: 6 } },
          { name: 'directional', caster: 'directional' },
        ] as const;
        return cases
          .filter(({ name, caster }) => (type !== 3 || caster !== 'point') && (type === 1 || !name.includes('radius')))
          .map(({ name, ...options }) => {
            const { scene, camera, lights } = shadowScene(width, height, options);
            // Farol comes first: three's first frame brings the cameras of shadows up to date
            const drawn = (['forward-single-pass', 'deferred'] as const).map((technique) => ({
              technique,
              image: bench.byTechnique(technique, scene, camera),
            }));
            const stock = bench.stock(scene, camera);
            for (const light of lights) light.castShadow = false;
            const without = bench.byTechnique('forward-single-pass', scene, camera);
            return {
              caster: name,
              matters: compareImages(stock, without).psnr,
              pairs: drawn.map(({ technique, image }) => ({ technique, ...compareImages(stock, image) })),
            };
          });
      },
      [WIDTH, HEIGHT, types[type]] as const,
    );
    for (const { caster, matters, pairs } of seen) {
      expect(matters, `${caster}: the shadows are to be seen`).toBeLessThan(32);
      for (const [i, { technique, psnr, share }] of pairs.entries()) {
        const said = `${caster}, ${technique}: ${psnr.toFixed(1)} dB, ${(share * 100).toFixed(2)}% off by more than 2/255`;
        test.info().annotations.push({ type: 'agreement', description: said });
        expectAsMeasured(psnr, measured[`${type}, ${caster}`][i], said);
      }
    }
  });
}

test('shadows of all kinds of light at once, by every technique', async ({ benchPage: page }) => {
  test.setTimeout(180_000);
  const pairs = await page.evaluate(
    ([width, height]) => {
      const { Bench, compareImages, shadowScene, techniquesInTurn } = window.testPage;
      const bench = new Bench(width, height);
      bench.webgl.shadowMap.enabled = true;
      const { scene, camera } = shadowScene(width, height, { caster: 'mixed' });
      const stock = bench.stock(scene, camera);
      return techniquesInTurn(4).map((technique) => ({
        technique,
        ...compareImages(stock, bench.byTechnique(technique, scene, camera)),
      }));
    },
    [WIDTH, HEIGHT] as const,
  );
  for (const { technique, psnr, share } of pairs) {
    const said = `${technique}: ${psnr.toFixed(1)} dB, ${(share * 100).toFixed(2)}% off by more than 2/255`;
    test.info().annotations.push({ type: 'agreement', description: said });
    expectAsMeasured(psnr, technique === 'inferred' ? 35.4 : 58.2, said);
  }
});

test('cookies: a spot light throws its map as in stock three, with and without shadows, and a point light its cube @verify', async ({
  benchPage: page,
}) => {
  const { pairs, cube } = await page.evaluate(
    ([width, height]) => {
      const { Bench, compareImages, setLightOptions, shadowScene, techniquesInTurn, three } = window.testPage;
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
        return techniquesInTurn(0, ['forward-single-pass', 'deferred', 'tiled-deferred']).map((technique) => ({
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
      for (const light of room.lights) setLightOptions(light, { cookie });
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
  for (const { name, psnr } of pairs) expectAsMeasured(psnr, name.startsWith('map and shadow') ? 70.2 : 71.8, name);
  expect(cube.wall[1], 'the wall is lit as before').toBeCloseTo(cube.wall[0], 3);
  expect(cube.floor[1], 'the floor is dark').toBeLessThan(0.3 * cube.floor[0]);
});

test('cascades: near shadows as sharp as those of a map sixteen times as wide, the far ones as in the one map', async ({
  benchPage: page,
}) => {
  const seen = await page.evaluate(() => {
    const { Bench, compareImages, three } = window.testPage;
    const bench = new Bench(128, 96);
    bench.webgl.shadowMap.enabled = true;
    const scene = new three.Scene();
    const camera = new three.PerspectiveCamera(50, 4 / 3, 0.1, 200);
    camera.position.set(0, 1.6, 4);
    camera.lookAt(0, 0.4, 0);
    const material = new three.MeshStandardMaterial();
    const floor = new three.Mesh(new three.PlaneGeometry(80, 80), material);
    floor.rotation.x = -Math.PI / 2;
    floor.receiveShadow = true;
    scene.add(floor);
    for (let i = 0; i < 12; i++) {
      const post = new three.Mesh(new three.BoxGeometry(0.2, 1.2, 0.2), material);
      post.position.set((i % 4) * 0.8 - 1.2, 0.6, -2 * Math.floor(i / 4));
      post.castShadow = true;
      scene.add(post);
    }
    const light = new three.DirectionalLight(0xffffff, 3);
    light.position.set(4, 10, 3);
    light.castShadow = true;
    light.shadow.bias = -0.0005;
    light.shadow.radius = 0.5;
    light.shadow.mapSize.set(128, 128);
    Object.assign(light.shadow.camera, { left: -30, right: 30, top: 30, bottom: -30, near: 1, far: 40 });
    scene.add(light);
    const draw = (technique: 'forward-single-pass' | 'deferred', cascades: number) => {
      bench.farol.shadowCascades = cascades;
      return bench.byTechnique(technique, scene, camera);
    };
    const one = draw('forward-single-pass', 1);
    const four = draw('forward-single-pass', 4);
    const drawn = bench.farol.info.shadows.drawn;
    const deferred = draw('deferred', 4);
    const kept = bench.farol.info.shadows.kept;
    camera.position.x = 0.3;
    draw('deferred', 4);
    const moved = bench.farol.info.shadows.drawn;
    camera.position.x = 0;
    light.shadow.mapSize.set(2048, 2048);
    const sharp = bench.stock(scene, camera);
    return {
      one: compareImages(sharp, one).psnr,
      four: compareImages(sharp, four).psnr,
      alike: compareImages(four, deferred).psnr,
      counts: [drawn, kept, moved],
    };
  });
  expect(seen.four, `${seen.one} dB with one map`).toBeGreaterThan(seen.one + 6);
  expectAsMeasured(seen.alike, 51.2, 'deferred beside forward');
  expect(seen.counts, 'drawn, kept at rest, drawn for another view').toEqual([1, 1, 1]);
});
