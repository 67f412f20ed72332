import { allocatedWarm, kept, least, LOOKS, KEPT } from './heap';
import type { FarolEffect as Effect } from '@farol/renderer';
import { expect, test } from './perfTest';

const LIGHTS = 40;
/** Bytes by which a frame with fog may differ: numbers that V8 puts on the heap to pass them, also one or two for each light. */
const GARBAGE = 600 + 30 * LIGHTS;
interface FogWindow {
  fogWorld: { world: ReturnType<typeof window.perf.world>; fog: Effect };
}
/** Frames until V8 has compiled what draws them. */
const WARM = 1500;

test('a frame with volumetric fog allocates next to nothing more, and keeps nothing @verify', async ({ page }) => {
  const session = await page.context().newCDPSession(page);
  await session.send('HeapProfiler.enable');
  await page.evaluate((lights) => {
    const { effects, three } = window.testPage;
    const { perf } = window;
    const world = perf.world('clustered-forward', { lights, objects: 9, spots: 8, width: 32, height: 32 });
    const fog = new effects.VolumetricFog();
    Object.assign(fog, { froxels: [16, 8, 16], noise: 0.4, time: 0 });
    const volume = new effects.FogVolume();
    world.scene.add(volume);
    Object.assign(window, { fogWorld: { world, fog } });
    const camera = new three.PerspectiveCamera(60, 1, 0.1, 50);
    camera.position.z = 4;
    const draw = () => world.farol.render(world.scene, camera);
    world.farol.effects = [fog];
    draw();
    perf.drawNothing();
    let frame = 0;
    window.perfFrames = function perfFrames(count) {
      for (let i = 0; i < count; i++) {
        fog.time = ++frame / 60;
        camera.position.x = 0.01 * (frame % 7);
        draw();
      }
    };
  }, LIGHTS);
  const warm = (hasFog: boolean) =>
    page.evaluate(
      ([has, frames]) => {
        const { world, fog } = (window as unknown as FogWindow).fogWorld;
        world.farol.effects = has ? [fog] : [];
        window.perfFrames(frames);
      },
      [hasFog, WARM] as const,
    );
  await warm(true);
  // once more without fog: what V8 compiles last is the leanest
  await warm(false);
  const clear = await allocatedWarm(page, session);
  await warm(true);
  const foggy = await allocatedWarm(page, session, clear + GARBAGE);
  const left = await least(LOOKS, KEPT, () => kept(page, session));
  const seen = `${clear.toFixed(0)} bytes a frame, ${foggy.toFixed(0)} with fog, ${left.toFixed(1)} kept`;
  test.info().annotations.push({ type: 'allocations', description: seen });
  expect(clear, seen).toBeGreaterThan(0);
  expect(foggy - clear, seen).toBeLessThanOrEqual(GARBAGE);
  expect(left, seen).toBeLessThanOrEqual(KEPT);
});
