import type { FarolRenderer } from '@farol/renderer';
import type { Camera, Scene } from 'three';

/** Frames that are drawn before the first that counts, and those that count. */
const BEFORE = 3;
const FRAMES = 12;
/** Frames after which GPU times that have not come are no longer waited for. */
const PATIENCE = 60;

/** Median time of a frame (ms), and by what it was taken. */
export interface Measurement {
  readonly ms: number;
  readonly by: 'gpu' | 'clock';
}

const nextFrame = (): Promise<unknown> => new Promise((resolve) => requestAnimationFrame(resolve));

/** Median GPU time of Farol's passes; null where the browser has no timer query. */
async function byTimer(
  farol: FarolRenderer,
  scene: Scene,
  camera: Camera,
  isAsked: () => boolean,
): Promise<number | null> {
  if (!farol.webgl.extensions.has('EXT_disjoint_timer_query_webgl2')) return null;
  farol.timing = true;
  const times: number[] = [];
  for (let i = 0; i < PATIENCE && times.length < FRAMES && isAsked(); i++) {
    farol.render(scene, camera);
    const { gpuMs } = farol.info;
    if (i >= BEFORE && gpuMs !== null && gpuMs > 0) times.push(gpuMs);
    await nextFrame();
  }
  farol.timing = false;
  return times.length > 0 ? median(times) : null;
}

/** Median time from the draw of a frame to a pixel of it that is read back: CPU and GPU together. */
async function byClock(farol: FarolRenderer, scene: Scene, camera: Camera, isAsked: () => boolean): Promise<number> {
  const gl = farol.webgl.getContext();
  const pixel = new Uint8Array(4);
  const times: number[] = [];
  for (let i = 0; i < BEFORE + FRAMES && isAsked(); i++) {
    const start = performance.now();
    farol.render(scene, camera);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    if (i >= BEFORE) times.push(performance.now() - start);
    await nextFrame();
  }
  return median(times);
}

function median(times: number[]): number {
  return times.sort((a, b) => a - b)[Math.floor(times.length / 2)] ?? 0;
}

/**
 * Times frames of a scene, by GPU timer queries where there are any, else by the page's clock.
 * @param isAsked - false once nobody waits for the result
 */
export async function measure(
  farol: FarolRenderer,
  scene: Scene,
  camera: Camera,
  isAsked: () => boolean,
): Promise<Measurement> {
  farol.render(scene, camera);
  const { ready } = farol;
  farol.render(scene, camera);
  await ready;
  const gpu = await byTimer(farol, scene, camera, isAsked);
  if (gpu !== null) return { ms: gpu, by: 'gpu' };
  return { ms: await byClock(farol, scene, camera, isAsked), by: 'clock' };
}
