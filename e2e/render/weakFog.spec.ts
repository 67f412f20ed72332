import { expect, test } from '../support/benchTest';

/** Lights of a street at whose ends fog must wait for its turns. */
const MANY = 150;

test('fog on a software rasteriser has fewer froxels and gathers fewer frames; a host that sets froxels has those @software', async ({
  benchPage: page,
}) => {
  const { before, after, set, refused } = await page.evaluate(async () => {
    const { FogScene, effects, farol } = window.testPage;
    await farol.FarolRenderer.preload();
    const fogScene = new FogScene(64, 40);
    const fog = new effects.VolumetricFog();
    const before = [...fog.froxels, fog.stillFrames];
    Object.assign(fogScene, { fog });
    fogScene.byFarol('deferred', 1);
    const after = [...fog.froxels, fog.stillFrames];
    fog.froxels = [16, 8, 16];
    fogScene.byFarol('deferred', 1);
    const { width, height, depth } = fog.scattered!.image;
    let refused = '';
    try {
      fog.froxels = [16, 8, 12];
    } catch (error) {
      refused = String(error);
    }
    return { before, after, set: [width, height, depth], refused };
  });
  expect(before).toEqual([160, 90, 64, 64]);
  expect(after).toEqual([64, 36, 32, 8]);
  expect(set).toEqual([16, 8, 16]);
  expect(refused).toContain('multiple of 8');
});

test('fog of few froxels, lit by turns, comes near to a march of 512 steps within the frames that it asks for, at rest and in motion @verify @software', async ({
  benchPage: page,
}) => {
  test.slow();
  const rows = await page.evaluate(async (many) => {
    const { FogScene, compareImages, effects, farol, three } = window.testPage;
    await farol.FarolRenderer.preload();
    const cases = [
      { idle: 0, froxels: null },
      { idle: many, froxels: null },
      // as wide in pixels as at 1280 × 720
      { idle: 0, froxels: [13, 7, 32] as const },
    ];
    return cases.map(({ idle, froxels }) => {
      const fogScene = new FogScene();
      const { camera, scene } = fogScene;
      const fog = new effects.VolumetricFog();
      const { density, anisotropy, height, falloff, distance, time, albedo } = fogScene.fog;
      Object.assign(fog, { density, anisotropy, height, falloff, distance, time });
      fog.albedo.copy(albedo);
      fog.froxels = froxels;
      Object.assign(fogScene, { fog });
      const march = fogScene.byMarch();
      // lights that give nothing but count: froxels are lit by turns
      for (let i = 0; i < idle; i++) {
        const light = new three.PointLight(0xffffff, 1e-9, 0.5);
        light.position.set((i % 10) - 5, 0.2, -Math.floor(i / 10));
        scene.add(light);
      }
      fogScene.byFarol('deferred', 1);
      const still = compareImages(march, fogScene.byFarol('deferred', fog.stillFrames)).psnr;
      const first = compareImages(march, fogScene.byFarol('deferred', 1)).psnr;
      const { x, z } = camera.position;
      const turn = camera.rotation.y;
      const picture = fogScene.byFarol('deferred', 16, (frame) => {
        camera.position.x = x + (15 - frame) * 0.02;
        camera.position.z = z + (15 - frame) * 0.03;
        camera.rotation.y = turn - (15 - frame) * 0.004;
      });
      return {
        idle: `${idle} idle lights, froxels ${fog.froxels.join()}`,
        first,
        still,
        moving: compareImages(march, picture).psnr,
      };
    });
  }, MANY);
  for (const { idle, first, still, moving } of rows) {
    const figures = [first, still, moving].map((psnr) => psnr.toFixed(1)).join(', ');
    test.info().annotations.push({ type: 'dB', description: `${idle}: first, at rest, in motion ${figures}` });
    expect.soft(first, `${idle}: first frame`).toBeGreaterThanOrEqual(20);
    expect.soft(still, `${idle}: at rest`).toBeGreaterThanOrEqual(30);
    expect.soft(moving, `${idle}: in motion`).toBeGreaterThanOrEqual(28);
  }
});

test('the light of a lamp that is switched off leaves the fog of a still scene @verify', async ({
  benchPage: page,
}) => {
  const psnr = await page.evaluate(async () => {
    const { FogScene, compareImages, farol, three } = window.testPage;
    await farol.FarolRenderer.preload();
    const fogScene = new FogScene(64, 40);
    const { scene, bench, camera } = fogScene;
    const lamp = new three.PointLight(0xff2000, 30, 8);
    lamp.position.set(0, 1.5, -3);
    const dark = fogScene.byFarol('deferred', 24);
    scene.add(lamp);
    fogScene.byFarol('deferred', 24);
    lamp.visible = false;
    let image = dark;
    for (let i = 0; i < fogScene.fog.stillFrames; i++) image = bench.byTechnique('deferred', scene, camera);
    return compareImages(dark, image).psnr;
  });
  expect(psnr).toBeGreaterThan(40);
});
