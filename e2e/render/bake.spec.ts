import { expect, test } from '../support/benchTest';

/**
 * Bakes are compared with what is known: three's own direct light, a closed room that shines (a white furnace), light that
 * a second plane reflects, integrated in numbers.
 */
test('baked light is the light of known scenes, by every technique, and leaves the scene as it was', async ({
  benchPage: page,
}) => {
  const found = await page.evaluate(async () => {
    const { Bench, three, compareImages, bake, techniquesInTurn } = window.testPage;
    const { bakeLightmaps } = await bake();
    const bench = new Bench(48, 48);
    const { webgl } = bench;
    const warnings: string[] = [];
    const onWarning = (sentence: string) => warnings.push(sentence);

    // a floor, half of it in the shadow of a screen, by a point and a spot light
    const floorScene = new three.Scene();
    const floor = new three.Mesh(new three.PlaneGeometry(4, 4), new three.MeshLambertMaterial({ color: 0x808080 }));
    const screen = new three.Mesh(
      new three.PlaneGeometry(1, 1),
      new three.MeshBasicMaterial({ side: three.DoubleSide, transparent: true, opacity: 1 }),
    );
    screen.position.set(1, 1, 1);
    const point = new three.PointLight(0xffeedd, 4, 6);
    point.position.set(1, 1, 2);
    const spot = new three.SpotLight(0x88aaff, 9, 0, 0.5, 0.4);
    spot.position.set(-1, -1, 2);
    spot.target.position.set(-1, -1, 0);
    floorScene.add(floor, screen, point, spot, spot.target);
    const camera = new three.OrthographicCamera(-2, 2, 2, -2, 0.1, 10);
    camera.position.z = 0.9; // below the screen
    const stock = bench.stock(floorScene, camera);
    const before = JSON.stringify([floor.uuid, floor.geometry.uuid, floor.material.uuid, point.layers.mask]);
    const options = { size: 64, bounces: 0, samples: 8, onWarning };
    const baked = await bakeLightmaps(webgl, floorScene, options);
    baked.apply();
    const byThree = bench.stock(floorScene, camera);
    const differences: Record<string, number> = {};
    for (const name of techniquesInTurn(3)) {
      differences[name] = compareImages(byThree, bench.byTechnique(name, floorScene, camera)).largest;
    }
    baked.remove();
    const after = JSON.stringify([floor.uuid, floor.geometry.uuid, floor.material.uuid, point.layers.mask]);
    const pixel = (image: typeof stock, x: number, y: number) =>
      Array.from(image.data.slice(4 * (48 * y + x), 4 * (48 * y + x) + 3));
    const lit = [
      [pixel(stock, 12, 12), pixel(byThree, 12, 12)],
      [pixel(stock, 20, 30), pixel(byThree, 20, 30)],
      [pixel(stock, 40, 12), pixel(byThree, 40, 12)],
    ];
    const shadowed = [pixel(stock, 36, 36), pixel(byThree, 36, 36)];

    // two planes in a corner: the wall is lit straight on, the floor by what the wall reflects alone
    const corner = new three.Scene();
    const ground = new three.Mesh(new three.PlaneGeometry(1, 1), new three.MeshLambertMaterial());
    ground.position.set(0.5, 0.5, 0);
    const wall = new three.Mesh(new three.PlaneGeometry(1, 1), new three.MeshLambertMaterial({ color: 0xbcbcbc }));
    wall.position.set(0, 0.5, 0.5);
    wall.rotation.y = Math.PI / 2;
    const sun = new three.DirectionalLight(0xffffff, 2);
    sun.position.set(1, 0, 0);
    corner.add(ground, wall, sun);
    const cornerOptions = { size: 32, bounces: 1, samples: 512, denoise: false, onWarning, showProgress: false };
    const bounced = await bakeLightmaps(webgl, corner, cornerOptions);
    const again = await bakeLightmaps(webgl, corner, { ...cornerOptions, sliceMilliseconds: 4 });
    const isSame = bounced.lightmaps[0].data.every((half, i) => half === again.lightmaps[0].data[i]);
    // the wall shows its back: a surface of two sides gives its light to both, one of a single side not
    const half = three.DataUtils.fromHalfFloat;
    /** Mean red of the texels of the ground, which the wall alone lights. */
    const groundOf = ({ lightmaps, meshes }: typeof bounced) => {
      const { uv1 } = meshes.find(({ mesh }) => mesh === ground)!;
      const along = (k: number) => Array.from(uv1).filter((_, i) => i % 2 === k);
      const [left, low] = [0, 1].map((k) => Math.ceil(Math.min(...along(k)) * 32) + 1);
      const [right, high] = [0, 1].map((k) => Math.floor(Math.max(...along(k)) * 32) - 2);
      let sum = 0;
      for (let y = low; y <= high; y++)
        for (let x = left; x <= right; x++) sum += half(lightmaps[0].data[4 * (y * 32 + x)]);
      return sum / ((right - left + 1) * (high - low + 1));
    };
    wall.rotation.y = -Math.PI / 2;
    sun.position.set(-1, 0, 0);
    const backs: number[] = [];
    for (const side of [three.DoubleSide, three.FrontSide]) {
      wall.material.side = side;
      backs.push(groundOf(await bakeLightmaps(webgl, corner, { ...cornerOptions, samples: 64 })) / groundOf(bounced));
    }
    const { uv1, index, sourceVertex } = bounced.meshes.find(({ mesh }) => mesh === ground)!;
    /** Texel of a corner of three's plane: 0 left above, 1 right above, 2 left below. */
    const texelOf = (vertex: number) => {
      const at = [...index].find((i) => sourceVertex[i] === vertex)!;
      return new three.Vector2(uv1[2 * at], uv1[2 * at + 1]).multiplyScalar(32);
    };
    const [leftAbove, right, below] = [texelOf(0), texelOf(1).sub(texelOf(0)), texelOf(2).sub(texelOf(0))];
    /** Ratio of the ground's texels to the light computed there. */
    const ratios: number[] = [];
    const steps = 60;
    for (let texel = 0; texel < 32 * 32; texel++) {
      const from = new three.Vector2((texel % 32) + 0.5, Math.floor(texel / 32) + 0.5).sub(leftAbove);
      const [u, v] = [from.dot(right) / right.lengthSq(), from.dot(below) / below.lengthSq()];
      if (u < 0.05 || u > 0.95 || v < 0.05 || v > 0.95) continue;
      let sum = 0;
      for (let i = 0; i < steps; i++)
        for (let j = 0; j < steps; j++) {
          const [y, z] = [(i + 0.5) / steps - v, (j + 0.5) / steps];
          // cosines to both normals, by the square of the distance
          sum += (z * u) / (u * u + y * y + z * z) ** 2 / steps ** 2;
        }
      ratios.push(half(bounced.lightmaps[0].data[4 * texel]) / ((wall.material.color.r * 2 * sum) / Math.PI));
    }
    const reflected = ratios.reduce((a, b) => a + b) / ratios.length;
    const texels = ratios.length;

    // a bake that is cancelled while it is shown
    const abort = new AbortController();
    let shown = '';
    const cancelled = await bakeLightmaps(webgl, floorScene, {
      ...{ ...options, samples: 4096, bounces: 4, signal: abort.signal },
      onProgress: ({ stage }) => {
        if (stage !== 'tracing') return;
        shown = floor.geometry.uuid;
        abort.abort();
      },
    }).catch((error: Error) => error.name);
    const isShown = shown !== '' && shown !== floor.geometry.uuid;
    const left = JSON.stringify([floor.uuid, floor.geometry.uuid, floor.material.uuid, point.layers.mask]);

    // a closed room of albedo a whose walls emit e: after n bounces each point receives pi e (1 + a + … + a^n)
    const room = new three.Scene();
    const walls = new three.MeshStandardMaterial({ side: three.BackSide, emissive: 0xffffff, emissiveIntensity: 0.5 });
    walls.color.setRGB(0.6, 0.3, 0);
    room.add(new three.Mesh(new three.BoxGeometry(2, 2, 2), walls));
    const furnace = await bakeLightmaps(webgl, room, {
      ...{ size: 32, bounces: 3, samples: 16, denoise: false, onWarning, showProgress: false },
      probes: Float32Array.of(0, 0, 0, 1.3, 0, 0),
    });
    const { data } = furnace.lightmaps[0];
    const at = (lightmap: Uint16Array, i: number) => [0, 1, 2].map((k) => half(lightmap[4 * i + k]));
    const inside = [...Array(data.length / 4).keys()].filter((i) => data[4 * i] > 0);
    const sum = inside.map((i) => at(data, i)).reduce((a, b) => a.map((value, k) => value + b[k]));
    const mean = sum.map((value) => value / inside.length);
    const lowest = Math.min(...inside.map((i) => at(data, i)[0]));

    const sh = new three.SphericalHarmonics3().fromArray(Array.from(furnace.probes!.coefficients));
    const probe = sh.getIrradianceAt(new three.Vector3(0.6, 0, 0.8), new three.Vector3()).toArray();
    const [within, outside] = furnace.probes!.backFaces;
    return {
      ...{
        warnings,
        before,
        after,
        left,
        isShown,
        differences,
        lit,
        shadowed,
        isSame,
        cancelled,
        reflected,
        texels,
        backs,
      },
      ...{ mean, lowest, probe, within, outside, share: inside.length / (data.length / 4) },
    };
  });
  expect(found.warnings).toEqual([]);
  for (const [stock, baked] of found.lit) {
    expect(stock[0]).toBeGreaterThan(0.01);
    stock.forEach((value, k) => expect(Math.abs(baked[k] - value), 'direct light').toBeLessThan(1e-3));
  }
  expect(found.shadowed[0][0]).toBeGreaterThan(0.05);
  expect(found.shadowed[1]).toEqual([0, 0, 0]);
  for (const [technique, largest] of Object.entries(found.differences)) {
    expect(largest, technique).toBeLessThan(1e-3);
  }
  expect(found.texels).toBeGreaterThan(60);
  expect(Math.abs(found.reflected - 1), 'light that a plane reflects').toBeLessThan(0.01);
  const [twoSided, oneSided] = found.backs;
  expect(twoSided, 'light at the back of a plane of two sides').toBeCloseTo(1, 1);
  expect(oneSided, 'light at the back of a plane of one side').toBe(0);
  const series = (albedo: number) => Math.PI * 0.5 * (1 + albedo + albedo ** 2 + albedo ** 3);
  [0.6, 0.3, 0].forEach((albedo, k) => {
    expect(Math.abs(found.mean[k] / series(albedo) - 1), `furnace ${albedo}`).toBeLessThan(0.01);
    // a probe's light is the lightmaps'
    expect(Math.abs(found.probe[k] / series(albedo) - 1), `probe ${albedo}`).toBeLessThan(0.02);
  });
  expect(found.lowest, 'no texel of the room sees out of it').toBeGreaterThan(0.75 * series(0.6));
  expect(found.share).toBeGreaterThan(0.4);
  expect(found.within).toBe(0);
  expect(found.outside).toBeGreaterThan(0);
  expect(found.isSame, 'the same seed').toBe(true);
  expect(found.cancelled).toBe('AbortError');
  expect(found.isShown, 'the picture so far').toBe(true);
  expect(found.left).toBe(found.before);
  expect(found.after).toBe(found.before);
});

/**
 * Meshes without a lightmap, and lights of other kinds. Instances and a skinned mesh stand in for the mesh of their shape, and must
 * give the light that it gives; a floor under a sky receives pi times its radiance.
 */
test('instances and bones cast shadows and reflect as meshes do; sky, soft suns, indirect lights and several lightmaps give known light @verify', async ({
  benchPage: page,
}) => {
  const found = await page.evaluate(async () => {
    const { Bench, three, bake } = window.testPage;
    const { bakeLightmaps, bakeProbes } = await bake();
    const { webgl } = new Bench(8, 8);
    const warnings: string[] = [];
    const shared = { size: 32, samples: 16, denoise: false, showProgress: false };
    type Options = Parameters<typeof bakeLightmaps>[2];
    /** Mean light of a mesh's texels, and how many lightmaps there are. */
    const bakeOf = async (scene: InstanceType<typeof three.Scene>, mesh: object, options: Options = {}) => {
      const onWarning = (sentence: string) => void warnings.push(sentence);
      const baked = await bakeLightmaps(webgl, scene, { ...shared, onWarning, ...options });
      const { uv1, lightmap } = baked.meshes.find((each) => each.mesh === mesh)!;
      const { width, data } = baked.lightmaps[lightmap];
      const along = (k: number) => Array.from(uv1).filter((_, i) => i % 2 === k);
      const [left, low] = [0, 1].map((k) => Math.ceil(Math.min(...along(k)) * width) + 1);
      const [right, high] = [0, 1].map((k) => Math.floor(Math.max(...along(k)) * width) - 2);
      const sum = [0, 0, 0];
      let count = 0;
      for (let y = low; y <= high; y++)
        for (let x = left; x <= right; x++, count++)
          sum.forEach((_, k) => (sum[k] += three.DataUtils.fromHalfFloat(data[4 * (y * width + x) + k])));
      const [lightmaps, meshes] = [baked.lightmaps.length, baked.meshes.length];
      baked.dispose();
      return { mean: sum.map((value) => value / count), lightmaps, meshes };
    };
    const white = new three.MeshLambertMaterial();
    const floor = new three.Mesh(new three.PlaneGeometry(2, 2), white);
    const sun = new three.DirectionalLight(0xffffff, 2);
    sun.position.set(1, 0, 0);

    // a red wall reflects the light of a level sun to the floor, which has no light else
    const shape = new three.PlaneGeometry(2, 2).rotateY(Math.PI / 2).translate(-1, 0, 1);
    const red = new three.MeshLambertMaterial({ color: new three.Color(0.8, 0.1, 0.05) });
    const colours = new three.InstancedMesh(shape, white, 2);
    colours.setMatrixAt(0, new three.Matrix4());
    colours.setMatrixAt(1, new three.Matrix4().makeTranslation(0, 0, 0));
    for (const i of [0, 1]) colours.setColorAt(i, red.color);
    const bones = shape.clone();
    const corners = bones.attributes.position.count;
    bones.translate(0, 5, 0);
    bones.setAttribute('skinIndex', new three.Uint16BufferAttribute(new Uint16Array(4 * corners), 4));
    const weights = Float32Array.from({ length: 4 * corners }, (_, i) => Number(i % 4 === 0));
    bones.setAttribute('skinWeight', new three.BufferAttribute(weights, 4));
    const skinned = new three.SkinnedMesh(bones, red);
    const bone = new three.Bone();
    skinned.add(bone);
    skinned.bind(new three.Skeleton([bone]));
    bone.position.y = -5;
    const mesh = new three.Mesh(shape, red);
    const walls: Record<string, Awaited<ReturnType<typeof bakeOf>>> = {};
    for (const [name, wall] of Object.entries({ mesh, instances: colours, skinned }))
      walls[name] = await bakeOf(new three.Scene().add(floor, wall, sun), floor, {
        bounces: 1,
        // one of the two instances moves
        isStatic: (_: object, instance?: number) => instance !== 1,
      });
    const live = await bakeOf(new three.Scene().add(floor, mesh, sun), floor, {
      bounces: 1,
      isBaked: () => 'indirect',
    });

    // a canopy of instances over the floor
    const canopy = new three.InstancedMesh(new three.PlaneGeometry(50, 50), white, 1);
    canopy.setMatrixAt(0, new three.Matrix4().makeTranslation(0, 0, 1));
    const above = new three.DirectionalLight(0xffffff, 3);
    above.position.set(0, 0, 1);
    above.userData.farol = { angle: 0.3 };
    const open = await bakeOf(new three.Scene().add(floor, above), floor, { bounces: 0 });
    const under = await bakeOf(new three.Scene().add(floor, above, canopy), floor, { bounces: 0 });
    // half of a wide sun is hidden by a wall that ends at the middle of the floor's sky
    const half = new three.Mesh(
      new three.PlaneGeometry(50, 50),
      new three.MeshBasicMaterial({ side: three.DoubleSide }),
    );
    half.position.set(25, 0, 40);
    const soft = await bakeOf(new three.Scene().add(floor, above, half), floor, { bounces: 0 });
    const indirect = await bakeOf(new three.Scene().add(floor, above), floor, {
      bounces: 2,
      isBaked: () => 'indirect',
    });

    // a sky alone; a normal map changes nothing of what is baked; finer texels take more lightmaps
    const bumps = new three.DataTexture(new Uint8Array(64).fill(200), 4, 4);
    bumps.needsUpdate = true;
    const bumpy = new three.Mesh(floor.geometry, new three.MeshStandardMaterial({ normalMap: bumps }));
    bumpy.position.z = -3;
    const sky = await bakeOf(new three.Scene().add(bumpy), bumpy, { bounces: 0, sky: new three.Color(0.2, 0.4, 0.6) });
    bumpy.position.x = 5;
    const several = await bakeOf(new three.Scene().add(floor, bumpy, above), bumpy, { bounces: 0, texelsPerMetre: 12 });

    // of a sun alone, far over a floor that it does not reach
    const slanted = new three.DirectionalLight(0xffffff, 2);
    slanted.position.set(1, 2, 3);
    const pit = new three.Scene().add(
      new three.Mesh(floor.geometry, new three.MeshStandardMaterial({ color: 0 })),
      slanted,
    );
    const probed = await bakeProbes(webgl, pit, Float32Array.of(0, 0, 9), { samples: 16, size: 16, bounces: 0 });
    const probe = [...probed.coefficients].filter((_, i) => i % 3 === 0);
    return { walls, live, warnings, open, under, soft, indirect, sky, several, probe };
  });
  const { walls } = found;
  expect(walls.mesh.mean[0]).toBeGreaterThan(0.05);
  for (const name of ['instances', 'skinned']) {
    expect(walls[name].meshes, name).toBe(1);
    expect(walls[name].lightmaps, name).toBe(1);
    walls[name].mean.forEach((value, k) =>
      expect(Math.abs(value / walls.mesh.mean[k] - 1), `${name}, light that is reflected`).toBeLessThan(0.05),
    );
  }
  // the sun lights the floor at no angle: only what the wall reflects is there, with the direct light or without
  found.live.mean.forEach((value, k) => expect(Math.abs(value / walls.mesh.mean[k] - 1)).toBeLessThan(0.01));
  expect(found.warnings.filter((each) => each.includes('gets no lightmap'))).toHaveLength(3);
  for (const value of found.open.mean) expect(Math.abs(value / 3 - 1), 'a sun').toBeLessThan(1e-3);
  expect(found.under.mean, 'shadow of instances').toEqual([0, 0, 0]);
  for (const value of found.soft.mean) expect(Math.abs(value / 1.5 - 1), 'half of a wide sun').toBeLessThan(0.05);
  // nothing is there that reflects to the floor
  expect(found.indirect.mean).toEqual([0, 0, 0]);
  [0.2, 0.4, 0.6].forEach((radiance, k) =>
    expect(Math.abs(found.sky.mean[k] / (Math.PI * radiance) - 1), 'a sky').toBeLessThan(0.005),
  );
  // each spherical harmonic at the direction of the sun, times what reaches a surface that faces it
  const [x, y, z] = [1, 2, 3].map((value) => value / Math.sqrt(14));
  const bands = [0.488603 * y, 0.488603 * z, 0.488603 * x, 1.092548 * x * y, 1.092548 * y * z];
  const harmonics = [0.282095, ...bands, 0.315392 * (3 * z * z - 1), 1.092548 * x * z, 0.546274 * (x * x - y * y)];
  harmonics.forEach((value, i) => expect(found.probe[i], `coefficient ${i}`).toBeCloseTo(2 * value, 2));
  expect(found.several.lightmaps).toBe(2);
  for (const value of found.several.mean) expect(Math.abs(value / 3 - 1), 'several lightmaps').toBeLessThan(1e-3);
});
