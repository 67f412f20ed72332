import type { FarolInfo, TechniqueName } from '@farol/renderer';
import { scenes } from '@farol/scenes';
import * as three from 'three';
import type { FarolRenderer } from '@farol/renderer';

/** Ways to draw: one eye without a session, both eyes in one. */
const modes = ['mono', 'stereo'] as const;
export type StereoMode = (typeof modes)[number];

export interface StereoOptions {
  readonly technique: TechniqueName;
  readonly lights: number;
  /** Lights with shadow maps. */
  readonly shadows: number;
  /** Number of rounds, in each of which every mode is timed for a turn. */
  readonly rounds: number;
  /** Frames of a turn that are timed together. */
  readonly frames: number;
}

export interface StereoTimes {
  /** Milliseconds a frame until the GPU has finished, as the median of the turns. */
  batch: number;
  /** Milliseconds a frame until all calls have returned. */
  calls: number;
  /** Milliseconds a frame by EXT_disjoint_timer_query_webgl2; null where it has none. */
  gpu: number | null;
  /** Draws of WebGL a frame. */
  draws: number;
  /** Times that shadow maps are drawn a frame. */
  shadowMaps: number;
  passes: string[];
}

/** Session of the page's bench; see XRBench. */
interface StereoBench {
  readonly webgl: three.WebGLRenderer;
  readonly farol: FarolRenderer;
  frame<Result>(draw: () => Result): Promise<Result>;
  settle(technique: TechniqueName, scene: three.Scene, camera: three.Camera): Promise<void>;
}

const median = (values: number[]): number => values.toSorted((a, b) => a - b)[values.length >> 1] ?? NaN;

/** Calls of draws of WebGL while a function runs. */
function countDraws(gl: WebGL2RenderingContext, run: () => void): number {
  let draws = 0;
  const names = ['drawArrays', 'drawElements', 'drawArraysInstanced', 'drawElementsInstanced'] as const;
  for (const name of names) {
    const own = gl[name].bind(gl) as (...args: unknown[]) => void;
    Object.assign(gl, { [name]: (...args: unknown[]) => (draws++, own(...args)) });
  }
  run();
  for (const name of names) Reflect.deleteProperty(gl, name);
  return draws;
}

/** Times the atrium in a session: see `StereoTimes`. One of its lamps moves, so that shadow maps are drawn in each frame. */
export async function timeStereo(
  bench: StereoBench,
  { technique, lights, shadows, rounds, frames }: StereoOptions,
): Promise<Record<StereoMode, StereoTimes> & { eye: number[] }> {
  const { webgl, farol } = bench;
  const gl = webgl.getContext() as WebGL2RenderingContext;
  webgl.shadowMap.enabled = true;
  const made = await scenes.sponza.build({ lights, shadows });
  const scene = made.three as unknown as three.Scene;
  const { position, quaternion } = made.activeCamera!.three;
  const rig = new three.Group();
  rig.position.copy(position).y -= 1.6;
  rig.quaternion.copy(quaternion);
  const camera = new three.PerspectiveCamera(70, 1, 0.1, 100);
  rig.add(camera);
  scene.add(rig);
  const eye = new three.PerspectiveCamera();
  eye.matrixWorldAutoUpdate = false;
  let viewport = new three.Vector4();
  const draw = (mode: StereoMode) => {
    made.update(1 / 60);
    if (mode !== 'mono') return farol.render(scene, camera);
    const layer = webgl.getRenderTarget()!;
    const whole = layer.viewport.clone();
    layer.viewport.copy(viewport);
    webgl.xr.enabled = false;
    webgl.setRenderTarget(layer);
    farol.render(scene, eye);
    layer.viewport.copy(whole);
    webgl.setRenderTarget(layer);
    webgl.xr.enabled = true;
  };
  await bench.settle(technique, scene, camera);
  await bench.frame(() => {
    const [first] = webgl.xr.getCamera().cameras as (three.PerspectiveCamera & { viewport: three.Vector4 })[];
    eye.projectionMatrix.copy(first.projectionMatrix);
    eye.projectionMatrixInverse.copy(first.projectionMatrixInverse);
    eye.matrixWorld.copy(first.matrixWorld);
    eye.matrixWorldInverse.copy(first.matrixWorldInverse);
    viewport = first.viewport.clone();
  });
  const finish = () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  const timer = gl.getExtension('EXT_disjoint_timer_query_webgl2') as { TIME_ELAPSED_EXT: number } | null;
  const turns = modes.map(() => ({ batch: [] as number[], calls: [] as number[], gpu: [] as number[] }));
  const shown: { draws: number; info: FarolInfo }[] = [];
  for (const mode of modes) {
    shown.push(
      await bench.frame(() => {
        draw(mode);
        return { draws: countDraws(gl, () => draw(mode)), info: structuredClone(farol.info) };
      }),
    );
  }
  for (let round = 0; round < rounds; round++)
    for (const [i, mode] of modes.entries()) {
      await bench.frame(() => {
        draw(mode);
        finish();
        const begin = performance.now();
        for (let frame = 0; frame < frames; frame++) draw(mode);
        turns[i].calls.push((performance.now() - begin) / frames);
        finish();
        turns[i].batch.push((performance.now() - begin) / frames);
      });
      if (timer === null) continue;
      const query = gl.createQuery();
      await bench.frame(() => {
        gl.beginQuery(timer.TIME_ELAPSED_EXT, query);
        draw(mode);
        gl.endQuery(timer.TIME_ELAPSED_EXT);
      });
      while (gl.getQueryParameter(query, gl.QUERY_RESULT_AVAILABLE) !== true) await bench.frame(() => undefined);
      turns[i].gpu.push((gl.getQueryParameter(query, gl.QUERY_RESULT) as number) / 1e6);
      gl.deleteQuery(query);
    }
  const times = modes.map((mode, i): [StereoMode, StereoTimes] => {
    const passes = shown[i].info.passes.map(({ name }) => name);
    const gpu = turns[i].gpu.length > 0 ? median(turns[i].gpu) : null;
    const shadowMaps = passes.filter((name) => name.startsWith('shadow maps')).length;
    const { batch, calls } = turns[i];
    return [mode, { batch: median(batch), calls: median(calls), gpu, draws: shown[i].draws, shadowMaps, passes }];
  });
  return { ...(Object.fromEntries(times) as Record<StereoMode, StereoTimes>), eye: [viewport.z, viewport.w] };
}
