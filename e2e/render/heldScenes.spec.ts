import { expect, test } from '../support/test';

/** Scenes that are opened and closed. */
const SCENES = 50;

test('scenes that were opened and closed leave nothing, also where few frames are drawn @verify', async ({
  benchPage: page,
}) => {
  await page.evaluate(() => {
    const { Bench, countGpuObjects, effects, three } = window.testPage;
    const count = countGpuObjects();
    const bench = new Bench(64, 48);
    const { webgl } = bench;
    webgl.shadowMap.enabled = true;
    const camera = new three.PerspectiveCamera(50, 64 / 48, 0.1, 30);
    camera.position.set(0, 3, 6);
    camera.lookAt(0, 0, 0);
    bench.farol.effects = [new effects.TAA()];
    const open = () => {
      const scene = new three.Scene();
      const material = new three.MeshStandardMaterial();
      const floor = new three.Mesh(new three.PlaneGeometry(8, 8), material);
      floor.rotation.x = -Math.PI / 2;
      floor.receiveShadow = true;
      const knot = new three.Mesh(new three.TorusKnotGeometry(0.8, 0.3, 64, 8), material);
      knot.position.y = 1.5;
      knot.castShadow = true;
      const light = new three.SpotLight(0xffffff, 100, 20, 0.6, 0.3);
      light.position.set(1, 6, 2);
      light.castShadow = true;
      const map = new three.DataTexture(new Uint8Array([255, 200, 90, 255]), 1, 1);
      map.needsUpdate = true;
      light.map = map;
      scene.add(floor, knot, light);
      const draw = () => {
        for (let i = 0; i < 3; i++) bench.byTechnique('deferred', scene, camera);
      };
      const close = () => {
        for (const mesh of [floor, knot]) mesh.geometry.dispose();
        material.dispose();
        light.dispose();
        map.dispose();
      };
      return { scene, draw, close };
    };
    const kept = open();
    const state = () => ({ ...count(), ...webgl.info.memory, programs: bench.programs });
    const opened = () => {
      const { draw, close } = open();
      draw();
      close();
      kept.draw();
    };
    // the textures of lights, which take turns, are all there after a few
    for (let i = 0; i < 5; i++) opened();
    Object.assign(window, { heldState: state, openScenes: (count: number) => Array.from({ length: count }, opened) });
  });
  const session = await page.context().newCDPSession(page);
  const held = async () => {
    await session.send('HeapProfiler.collectGarbage');
    return page.evaluate(() => (window as unknown as { heldState(): { geometries: number } }).heldState());
  };
  await expect.poll(async () => (await held()).geometries, 'those of the open scene, and its merged casters').toBe(3);
  const first = await held();
  await page.evaluate((count) => (window as unknown as { openScenes(n: number): void }).openScenes(count), SCENES);
  await expect.poll(held).toEqual(first);
});
