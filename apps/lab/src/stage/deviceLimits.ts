import { loseContext } from './loseContext';

/** Name and limits of a graphics device. */
export interface DeviceLimits {
  /** Name by WEBGL_debug_renderer_info. */
  readonly renderer: string;
  readonly timer: boolean;
  /** Maximum number of uniform vectors of a fragment shader. */
  readonly fragmentUniforms: number;
  /** Maximum number of textures of a fragment shader. */
  readonly textures: number;
  /** Whether programs compile in parallel with the page (KHR_parallel_shader_compile). */
  readonly compilesBeside: boolean;
}

let known: DeviceLimits | null = null;

/** Limits of the device, queried once with a temporary context. @throws Error when WebGL 2 is not available */
export function deviceLimits(): DeviceLimits {
  if (known) return known;
  const canvas = document.createElement('canvas');
  const gl = canvas.getContext('webgl2', { powerPreference: 'high-performance' });
  if (!gl) {
    throw new Error('This browser has no WebGL 2: switch hardware acceleration on in its settings, or update it.');
  }
  const debug = gl.getExtension('WEBGL_debug_renderer_info');
  known = {
    renderer: String(gl.getParameter(debug ? debug.UNMASKED_RENDERER_WEBGL : gl.RENDERER)),
    timer: gl.getExtension('EXT_disjoint_timer_query_webgl2') !== null,
    fragmentUniforms: gl.getParameter(gl.MAX_FRAGMENT_UNIFORM_VECTORS) as number,
    compilesBeside: gl.getExtension('KHR_parallel_shader_compile') !== null,
    textures: gl.getParameter(gl.MAX_TEXTURE_IMAGE_UNITS) as number,
  };
  loseContext(gl);
  return known;
}

/** Reason, a sentence, why WebGL 2 is not available; null if it is. */
export function webglProblem(): string | null {
  try {
    deviceLimits();
    return null;
  } catch (error) {
    return (error as Error).message;
  }
}
