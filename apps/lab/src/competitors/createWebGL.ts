import { WebGLRenderer } from 'three';
import type { StageScene } from '../stage/StageScene';

/** three's WebGLRenderer as all competitors use it: no anti-aliasing, no tone mapping, sRGB, pixel ratio 1. */
export interface PlainWebGL {
  readonly renderer: WebGLRenderer;
  readonly gl: WebGL2RenderingContext;
  /** Checks the programs. @throws Error with the first line of the compiler's log if a program did not compile */
  check(): void;
  dispose(): void;
}

/**
 * Makes the renderer of a case, with shadow maps if a light casts shadows.
 *
 * @throws Error when WebGL 2 is not available
 */
export function createWebGL(canvas: HTMLCanvasElement, { width, height, lights, still }: StageScene): PlainWebGL {
  const renderer = new WebGLRenderer({ canvas, antialias: false, powerPreference: 'high-performance' });
  renderer.setPixelRatio(1);
  renderer.setSize(width, height, false);
  renderer.shadowMap.enabled = [...lights, ...still].some(({ castShadow }) => castShadow);
  let problem = '';
  renderer.debug.onShaderError = (gl, program, vertex, fragment) => {
    problem ||= firstLine(gl.getProgramInfoLog(program), gl.getShaderInfoLog(fragment), gl.getShaderInfoLog(vertex));
  };
  return {
    renderer,
    gl: renderer.getContext() as WebGL2RenderingContext,
    check() {
      if (problem) throw new Error(`A shader does not compile on this device: ${problem}`);
    },
    dispose: () => renderer.dispose(),
  };
}

/** First line of the first log of a shader compiler that is not empty, 200 letters at most. */
export function firstLine(...logs: (string | null)[]): string {
  const said = logs.map((log) => log?.replaceAll('\0', '').trim()).find((log) => log);
  return said?.split('\n')[0].slice(0, 200) ?? 'the compiler says nothing';
}
