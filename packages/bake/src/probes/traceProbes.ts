import {
  CustomBlending,
  DataTexture,
  FloatType,
  NearestFilter,
  OneFactor,
  RGBAFormat,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { FullscreenPass } from '../gpu/FullscreenPass';
import { keepState } from '../gpu/keepState';
import type { Slices } from '../gpu/Slices';
import { lightUniforms, type LightTable } from '../trace/lightTable';
import type { SkySource } from '../trace/SkySource';
import type { BakedProbes } from './BakedProbes';
import probes from './probes.glsl?raw';

/** Number of render targets for a probe's nine coefficients of three colours, and its share of back faces. */
const TARGETS = 7;
const FLOATS = 27;
/** Number of probes in a row of the targets. */
const WIDTH = 64;
const SAMPLES_OF_A_DRAW = 16;
/** Smallest number of samples of a probe: with fewer, even uniform light would be off by 1%. */
const LEAST_SAMPLES = 1024;

export interface ProbeTrace {
  /** World positions of the probes (m), three numbers each. */
  readonly points: Float32Array;
  readonly samples: number;
  readonly table: LightTable;
  readonly sky: SkySource;
  /** Uniforms of the scene and of its emitted and reflected light. */
  readonly uniforms: Record<string, { value: unknown }>;
  readonly defines: Record<string, unknown>;
  onSlice(share: number, samples: number): void;
}

/**
 * Traces the light at points; light reflected by surfaces is read from lightmaps.
 *
 * @throws Error when the device cannot render to seven targets at once
 */
export async function traceProbes(renderer: WebGLRenderer, slices: Slices, trace: ProbeTrace): Promise<BakedProbes> {
  const gl = renderer.getContext();
  // null while the context is lost
  const targets = gl.getParameter((gl as WebGL2RenderingContext).MAX_DRAW_BUFFERS) as number | null;
  if (targets !== null && targets < TARGETS) {
    throw new Error(
      `This device cannot bake probes: it draws to fewer than ${TARGETS} targets at once. Leave the probes out.`,
    );
  }
  const { points, table, sky } = trace;
  const count = points.length / 3;
  const height = Math.max(1, Math.ceil(count / WIDTH));
  const places = pointsTexture(points, count, height);
  const target = new WebGLRenderTarget(WIDTH, height, {
    ...{ depthBuffer: false, generateMipmaps: false, minFilter: NearestFilter, magFilter: NearestFilter },
    ...{ type: FloatType, count: TARGETS },
  });
  const first = { value: 0 };
  const pass = new FullscreenPass(
    'probes',
    probes,
    {
      ...{ ...trace.uniforms, ...lightUniforms(table), ...sky.uniforms },
      ...{ farol_points: { value: places }, farol_firstSample: first },
    },
    {
      ...{ transparent: true, blending: CustomBlending, blendSrc: OneFactor, blendDst: OneFactor },
      defines: { ...trace.defines, ...sky.defines, SAMPLES: SAMPLES_OF_A_DRAW },
    },
  );
  try {
    keepState(renderer, () => {
      renderer.setRenderTarget(target);
      renderer.clear();
    });
    const batches = Math.ceil(Math.max(trace.samples, LEAST_SAMPLES) / SAMPLES_OF_A_DRAW);
    await slices.run({
      ...{ height, batches },
      draw: (batch, rows) => {
        first.value = batch * SAMPLES_OF_A_DRAW;
        pass.draw(renderer, target, 0, rows);
      },
      onSlice: (share, batch) => trace.onSlice(share, batch * SAMPLES_OF_A_DRAW),
    });
    return await readProbes(renderer, target, count, batches * SAMPLES_OF_A_DRAW);
  } finally {
    pass.dispose();
    target.dispose();
    places.dispose();
  }
}

function pointsTexture(points: Float32Array, count: number, height: number): DataTexture {
  const data = new Float32Array(4 * WIDTH * height);
  for (let i = 0; i < count; i++) data.set([points[3 * i], points[3 * i + 1], points[3 * i + 2], 1], 4 * i);
  const texture = new DataTexture(data, WIDTH, height, RGBAFormat, FloatType);
  texture.needsUpdate = true;
  return texture;
}

async function readProbes(
  renderer: WebGLRenderer,
  target: WebGLRenderTarget,
  count: number,
  samples: number,
): Promise<BakedProbes> {
  const coefficients = new Float32Array(FLOATS * count);
  const backFaces = new Float32Array(count);
  const { width, height } = target;
  for (let t = 0; t < TARGETS; t++) {
    const data = new Float32Array(4 * width * height);
    await renderer.readRenderTargetPixelsAsync(target, 0, 0, width, height, data, undefined, t);
    for (let i = 0; i < count; i++) {
      for (let k = 0; k < 4; k++) {
        const value = data[4 * i + k] / samples;
        if (4 * t + k < FLOATS) coefficients[FLOATS * i + 4 * t + k] = value;
        else backFaces[i] = value;
      }
    }
  }
  return { coefficients, backFaces };
}
