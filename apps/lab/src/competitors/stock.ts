import { deviceLimits, webglProblem } from '../stage/deviceLimits';
import type { Competitor, Drawing } from './Competitor';
import { competitorNames } from './competitorNames';
import { createWebGL } from './createWebGL';
import { lackingInThree, refuseMatter } from './refuseMatter';
import { refuseTextures } from './refuseTextures';
import { smallFirstFrame } from './smallFirstFrame';

/** Numbers of uniform vectors that a shader uses for a point light, a spot light and a point light's shadow. */
const LIGHT = 2;
const SPOT = 4;
const SHADOW = 3;
/** Number of uniform vectors that a shader uses for everything but lights. */
const OTHERS = 16;
/** Number of lights from which compiling may hang the page: it runs in parallel, or its time is forecast. */
const MANY = 64;
/** Time between two polls of the compilation (ms). */
const POLL = 4;

/** three's own renderer, with every light in every shader. */
export const stock: Competitor = {
  name: 'stock',
  ...competitorNames.stock,
  unavailable: async () => webglProblem(),
  refuses(scene) {
    const { lights, shadows, kind } = scene;
    const lacking = refuseMatter(scene, lackingInThree);
    if (lacking !== null) return lacking;
    const vectors = kind === 'spots' ? SPOT : LIGHT;
    const { fragmentUniforms } = deviceLimits();
    if (lights * vectors + shadows * SHADOW + OTHERS <= fragmentUniforms) return null;
    const most = Math.max(0, Math.floor((fragmentUniforms - OTHERS - shadows * SHADOW) / vectors));
    return `Its shader holds ${most} lights at most on this device (${fragmentUniforms} uniform vectors), not ${lights}.`;
  },
  async open(canvas, scene, signal, longest): Promise<Drawing> {
    const { three, camera, lights, still } = scene;
    refuseTextures(scene, deviceLimits().textures);
    const count = lights.length + still.length;
    const isParallel = deviceLimits().compilesBeside;
    if (count >= MANY && !isParallel) refuseTime(compileForecast(count), longest, count);
    const { renderer, gl, check, dispose } = createWebGL(canvas, scene);
    async function drawFirst(): Promise<void> {
      const begin = performance.now();
      const isCompiled = watchLinks(gl);
      renderer.compile(three, camera);
      while (!isCompiled()) {
        await new Promise((resolve) => setTimeout(resolve, POLL));
        signal.throwIfAborted();
        refuseTime(performance.now() - begin, longest, count);
      }
      renderer.render(three, camera);
    }
    return {
      gl,
      render: () => renderer.render(three, camera),
      ...(count >= MANY && isParallel && { drawFirst }),
      check,
      dispose,
    };
  },
};

/** The constant COMPLETION_STATUS_KHR. */
const IS_COMPLETE = 0x91b1;

/** Records the programs that a context links. @returns a function: whether all programs are linked; never waits */
function watchLinks(gl: WebGL2RenderingContext): () => boolean {
  const programs: WebGLProgram[] = [];
  gl.linkProgram = (program) => {
    programs.push(program);
    WebGL2RenderingContext.prototype.linkProgram.call(gl, program);
  };
  return () => programs.every((program) => gl.getProgramParameter(program, IS_COMPLETE) as boolean);
}

/** Checks a compile time. @throws Error when compiling exceeds the limit of a first frame */
function refuseTime(ms: number, longest: number, lights: number): void {
  if (ms < longest) return;
  const [time, limit] = [ms, longest].map((each) => (each < 9950 ? (each / 1000).toFixed(1) : Math.round(each / 1000)));
  throw new Error(
    `Left out: its shader with ${lights} lights takes about ${time} s to compile here (limit ${limit} s).`,
  );
}

/** Numbers of lights whose shaders are compiled to forecast the compile time. */
const TRIED = [16, 64] as const;
/** Bounds of the growth of the compile time, as powers of the number of lights. */
const SLOPES = [1, 3] as const;

let samples: readonly number[] | null = null;

/**
 * Compile time of three's shader with many lights (ms), extrapolated from 16 and 64 lights: on some devices it is minutes,
 * during which the page would hang.
 */
function compileForecast(lights: number): number {
  samples ??= TRIED.map(smallFirstFrame);
  const slope = Math.log(samples[1] / samples[0]) / Math.log(TRIED[1] / TRIED[0]);
  return samples[1] * (lights / TRIED[1]) ** Math.min(SLOPES[1], Math.max(SLOPES[0], slope));
}
