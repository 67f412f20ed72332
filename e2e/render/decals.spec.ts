import { expect, test } from '../support/benchTest';

const TECHNIQUES = ['deferred', 'tiled-deferred', 'clustered-deferred'] as const;

test('a decal on a plane is as a mesh of the same material laid on it, under all lights and ambient occlusion or none', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(
    ([width, height, techniques]) => {
      const { Bench, compareImages, effects, three } = window.testPage;
      const bench = new Bench(width, height);
      const texture = (fill: (x: number, y: number) => number[]) => {
        const data = new Uint8Array(32 * 32 * 4);
        for (let i = 0; i < 32 * 32; i++) data.set(fill((i % 32) / 31, Math.floor(i / 32) / 31), i * 4);
        const result = new three.DataTexture(data, 32, 32);
        result.magFilter = three.LinearFilter;
        result.minFilter = three.LinearMipmapLinearFilter;
        result.generateMipmaps = true;
        result.needsUpdate = true;
        return result;
      };
      const map = texture((x, y) => [255 * x, 200, 255 * y, Math.hypot(x - 0.5, y - 0.5) < 0.45 ? 255 : 0]);
      map.colorSpace = three.SRGBColorSpace;
      const normalMap = texture((x, y) => [128 + 60 * Math.sin(12 * x), 128 + 60 * Math.cos(9 * y), 240, 255]);
      // in a place of its own
      normalMap.offset.set(0.3, 0.2);
      const scene = new three.Scene();
      scene.background = new three.Color(0.1, 0.1, 0.2);
      const floor = new three.Mesh(
        new three.PlaneGeometry(6, 6),
        new three.MeshStandardMaterial({ color: 0x886644, roughness: 0.7 }),
      );
      floor.rotation.x = -Math.PI / 2;
      const lamp = new three.PointLight(0xffeedd, 8, 8);
      lamp.position.set(0.5, 1, 0.5);
      const sun = new three.DirectionalLight(0xffffff, 0.7);
      sun.position.set(1, 2, 0);
      scene.add(
        floor,
        lamp,
        sun,
        new three.AmbientLight(0xffffff, 0.6),
        new three.HemisphereLight(0x8899ff, 0x332211, 1),
      );
      const camera = new three.PerspectiveCamera(45, width / height, 0.1, 20);
      camera.position.set(0.4, 1.8, 2.2);
      camera.lookAt(0, 0, 0);
      const surface = new three.MeshStandardMaterial({ map, normalMap, roughness: 0.35, metalness: 0.3 });
      surface.normalScale.set(0.9, -0.5);
      const laid = new three.Mesh(new three.PlaneGeometry(1.6, 1.2), surface.clone());
      Object.assign(laid.material, {
        transparent: true,
        depthWrite: false,
        polygonOffset: true,
        polygonOffsetFactor: -4,
      });
      const decal = new effects.Decal(surface);
      for (const object of [laid, decal]) {
        object.rotation.set(-Math.PI / 2, 0, 0.4);
        object.position.set(0.1, 0, 0.2);
        scene.add(object);
      }
      decal.scale.set(1.6, 1.2, 0.3);
      const list = [new effects.Decals()];
      decal.visible = false;
      const wanted = bench.stock(scene, camera);
      laid.visible = false;
      const without = bench.stock(scene, camera);
      decal.visible = true;
      bench.farol.effects = list;
      const figures = window.testPage.techniquesInTurn(2, techniques).map((technique) => {
        const { psnr, share } = compareImages(wanted, bench.byTechnique(technique, scene, camera), 6);
        return { technique, psnr, share };
      });
      // where depth is too coarse, and distances are stored
      const usual = bench.byTechnique('deferred', scene, camera);
      const wide = camera.clone();
      Object.assign(wide, { near: 1e-5, far: 1e4 }).updateProjectionMatrix();
      const coarse = compareImages(usual, bench.byTechnique('deferred', scene, wide)).psnr;
      // with ambient occlusion, which has its own share of indirect light: a plane alone closes nothing
      bench.farol.effects = [...list, new effects.AmbientOcclusion()];
      const occluded = compareImages(wanted, bench.byTechnique('deferred', scene, camera)).psnr;
      // two of them, one over the other, by renderOrder
      bench.farol.effects = list;
      const upper = new effects.Decal(new three.MeshStandardMaterial({ color: 0x00ff00 }));
      upper.rotation.copy(decal.rotation);
      upper.scale.set(0.4, 0.4, 0.3);
      upper.position.copy(decal.position);
      scene.add(upper);
      const pixel = () => {
        const middle = new three.Vector3().copy(decal.position).project(camera);
        const x = Math.floor((middle.x * 0.5 + 0.5) * width);
        const y = Math.floor((middle.y * 0.5 + 0.5) * height);
        const { data } = bench.byTechnique('deferred', scene, camera);
        return [...data.slice((y * width + x) * 4, (y * width + x) * 4 + 3)];
      };
      upper.renderOrder = 1;
      const over = pixel();
      upper.renderOrder = -1;
      const under = pixel();
      // from below, and what faces away: nothing
      upper.removeFromParent();
      decal.rotation.x = Math.PI / 2;
      const away = compareImages(without, bench.byTechnique('deferred', scene, camera)).largest;
      decal.rotation.x = -Math.PI / 2;
      decal.position.y = 0.2; // its box ends above the floor
      const above = compareImages(without, bench.byTechnique('deferred', scene, camera)).largest;
      return { figures, occluded, over, under, away, above, coarse, seen: compareImages(wanted, without).psnr };
    },
    [160, 120, TECHNIQUES] as const,
  );
  test.info().annotations.push({ type: 'decals', description: JSON.stringify(results) });
  expect(results.seen, 'the decal is seen').toBeLessThan(30);
  for (const { technique, psnr, share } of results.figures) {
    expect(psnr, technique).toBeGreaterThan(42);
    expect(share, technique).toBeLessThan(0.05);
  }
  expect(results.coarse, 'near 1e-5, far 1e4').toBeGreaterThan(50);
  expect(results.occluded).toBeGreaterThan(42);
  expect(results.over[1]).toBeGreaterThan(20 * results.over[0]);
  expect(results.under[1]).toBeLessThan(20 * results.under[0]);
  // what deferred shading rounds
  expect(results.away).toBeLessThan(1e-2);
  expect(results.above).toBeLessThan(1e-2);
});

test('techniques without a G-buffer say so once, and toMesh gives what they can draw', async ({
  benchPage: page,
  watch,
}) => {
  const { without, same, mesh } = await page.evaluate(() => {
    const { Bench, compareImages, effects, three } = window.testPage;
    const bench = new Bench(96, 64);
    const scene = new three.Scene();
    const ball = new three.Mesh(
      new three.SphereGeometry(1, 32, 24),
      new three.MeshStandardMaterial({ color: 0x999999 }),
    );
    scene.add(ball, new three.AmbientLight(0xffffff, 1));
    const camera = new three.PerspectiveCamera(45, 1.5, 0.1, 20);
    camera.position.z = 3;
    const without = bench.byTechnique('forward-single-pass', scene, camera);
    const decal = new effects.Decal(new three.MeshStandardMaterial({ color: 0xff0000 }));
    decal.position.z = 1;
    decal.scale.set(0.8, 0.8, 0.8);
    scene.add(decal);
    bench.farol.effects = [new effects.Decals()];
    bench.byTechnique('forward-single-pass', scene, camera);
    const same = compareImages(without, bench.byTechnique('forward-single-pass', scene, camera)).largest;
    const written = bench.byTechnique('deferred', scene, camera);
    const cut = decal.toMesh(ball);
    decal.removeFromParent();
    scene.add(cut);
    const mesh = compareImages(written, bench.byTechnique('forward-single-pass', scene, camera)).psnr;
    return { without: compareImages(without, written).psnr, same, mesh };
  });
  expect(same).toBe(0);
  expect(without, 'the decal shows').toBeLessThan(25);
  expect(mesh, 'the mesh cut out is where the decal is').toBeGreaterThan(30);
  expect(watch.forgive(/decals are not drawn.*toMesh/)).toBe(1);
});

test('the G-buffer and the light of it hold what three’s blending makes of colours, also of decals over decals', async ({
  benchPage: page,
}) => {
  const cells = await page.evaluate(() => {
    const { Bench, effects, three } = window.testPage;
    type Layer = readonly [blending: import('three').Blending, colour: number[], opacity: number];
    const { NormalBlending, AdditiveBlending, SubtractiveBlending, MultiplyBlending, NoBlending } = three;
    const some = [0.5, 0.1, 0.9];
    const layers: Layer[][] = [
      [],
      [[NormalBlending, some, 0.6]],
      [[AdditiveBlending, some, 0.6]],
      [[SubtractiveBlending, some, 0.6]],
      [[MultiplyBlending, some, 0.6]],
      [[NormalBlending, [1, 1, 1], 0.25]],
      [[NoBlending, some, 0.6]],
      [
        [AdditiveBlending, [0.1, 0.2, 0.9], 0.5],
        [AdditiveBlending, [0.2, 0.1, 0.9], 0.7],
      ],
      [
        [NormalBlending, [0.9, 0.8, 0.2], 1],
        [MultiplyBlending, some, 1],
      ],
      [
        [NormalBlending, [0.9, 0.8, 0.2], 1],
        [NormalBlending, some, 1],
      ],
    ];
    const pixels = 8;
    const count = layers.length;
    const bench = new Bench(count * pixels, pixels);
    const camera = new three.OrthographicCamera(0, count, 1, 0, 0.1, 10);
    camera.position.z = 5;
    const bare = [0.2, 0.3, 0.05];
    const wall = new three.Mesh(
      new three.PlaneGeometry(40, 4),
      new three.MeshStandardMaterial({ color: new three.Color(...bare), roughness: 0.9 }),
    );
    const scene = new three.Scene();
    scene.add(wall, new three.AmbientLight(0xffffff, 1));
    layers.forEach((each, cell) =>
      each.forEach(([blending, colour, opacity], order) => {
        const color = new three.Color(...colour);
        const decal = new effects.Decal(
          new three.MeshStandardMaterial({ color, opacity, blending, roughness: 0.2, metalness: 0 }),
        );
        decal.position.set(cell + 0.5, 0.5, 0);
        decal.renderOrder = order;
        scene.add(decal);
      }),
    );
    const texels = new Uint8Array(count * pixels * pixels * 4);
    const rows = [2, 3].map(() => texels.slice());
    const reader: import('@farol/renderer').FarolEffect = {
      name: 'reader',
      after: ['gbuffer'],
      bytes: 0,
      render: ({ resources }) => {
        const { target } = resources.get('gbuffer');
        for (const i of [2, 3])
          bench.webgl.readRenderTargetPixels(target, 0, 0, count * pixels, pixels, rows[i - 2], undefined, i);
      },
      dispose: () => {},
    };
    bench.farol.effects = [new effects.Decals(), reader];
    const { data } = bench.byTechnique('deferred', scene, camera);
    const blend = ([blending, colour, opacity]: Layer, below: number[]) =>
      below.map((b, i) => {
        const source = colour[i] * opacity;
        if (blending === AdditiveBlending) return Math.min(b + source, 1);
        if (blending === SubtractiveBlending) return b * (1 - source);
        return blending === MultiplyBlending ? b * source + b * (1 - opacity) : source + b * (1 - opacity);
      });
    return layers.map((each, cell) => {
      const at = ((pixels / 2) * count * pixels + (cell + 0.5) * pixels) * 4;
      const covers = each.length === 1 && [NormalBlending, NoBlending].includes(each[0][0] as 0 | 1);
      return {
        wanted: each.reduce((below, layer) => blend(layer, below), bare),
        albedo: [...rows[0].slice(at, at + 3)].map((value) => (value / 255) ** 2),
        light: [...data.slice(at, at + 3)],
        roughness: rows[1][at] / 255,
        wantedRoughness: covers ? 0.9 + (0.2 - 0.9) * each[0][2] : each.some(([b]) => b === NormalBlending) ? 0.2 : 0.9,
      };
    });
  });
  const [bare] = cells;
  cells.forEach(({ wanted, albedo, light, roughness, wantedRoughness }, cell) => {
    wanted.forEach((value, i) => {
      // what is stored is a square root in 8 bits
      expect(Math.abs(Math.sqrt(albedo[i]) - Math.sqrt(value)), `cell ${cell}, colour ${i}`).toBeLessThan(1.6 / 255);
      const lit = (light[i] / bare.light[i]) * bare.wanted[i];
      expect(Math.abs(lit / value - 1), `cell ${cell}, light ${i}`).toBeLessThan(0.04);
    });
    expect(roughness, `cell ${cell}`).toBeCloseTo(wantedRoughness, 2);
  });
});
