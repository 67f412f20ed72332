/** Source of a shader passed to a dry context. */
export interface DrySource {
  readonly stage: 'vertex' | 'fragment';
  readonly text: string;
}

/** Methods that only query, and are passed on to the real context. */
const QUESTIONS = [
  'getParameter',
  'getExtension',
  'getShaderPrecisionFormat',
  'getContextAttributes',
  'getSupportedExtensions',
];

/**
 * A fake WebGL 2 context that records shader sources: finds what a renderer would compile on this device without
 * compiling it.
 */
export function makeDryContext(gl: WebGL2RenderingContext): { context: WebGL2RenderingContext; sources: DrySource[] } {
  const sources: DrySource[] = [];
  const shaders = new Map<unknown, { stage: DrySource['stage']; text: string }>();
  const answers: Readonly<Record<string, (...args: never[]) => unknown>> = {
    createShader(type: number) {
      const shader = {};
      shaders.set(shader, { stage: type === gl.VERTEX_SHADER ? 'vertex' : 'fragment', text: '' });
      return shader;
    },
    shaderSource(shader: unknown, text: string) {
      const known = shaders.get(shader)!;
      known.text = text;
      sources.push({ stage: known.stage, text });
    },
    getShaderSource: (shader: unknown) => shaders.get(shader)?.text ?? '',
    getShaderParameter: () => true,
    getProgramParameter: (_program: unknown, name: number) =>
      name === gl.LINK_STATUS || name === gl.VALIDATE_STATUS ? true : 0,
    getShaderInfoLog: () => '',
    getProgramInfoLog: () => '',
    checkFramebufferStatus: () => gl.FRAMEBUFFER_COMPLETE,
    isContextLost: () => false,
    getError: () => gl.NO_ERROR,
    getQueryParameter: () => false,
  };
  const nothing = (): void => {};
  const made = (): object => ({});
  const context = new Proxy(gl, {
    get(_, name) {
      const value: unknown = Reflect.get(gl, name, gl);
      if (typeof value !== 'function') return value;
      const key = String(name);
      if (Object.hasOwn(answers, key)) return answers[key];
      if (QUESTIONS.includes(key)) return (value as () => unknown).bind(gl);
      return /^(create|fenceSync)/.test(key) ? made : nothing;
    },
  });
  return { context, sources };
}
