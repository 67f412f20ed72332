/** Extensions and limits that a device lacks of the one that the tests run on. */
export interface Subtraction {
  readonly extensions?: readonly string[];
  /** Limits by their names in WebGL. */
  readonly limits?: Readonly<Record<string, number>>;
  /** No `highp` in fragment shaders. */
  readonly mediump?: boolean;
}

const FLOATS = ['EXT_color_buffer_float', 'EXT_float_blend'];
const FEW_BUFFERS = { MAX_DRAW_BUFFERS: 4, MAX_COLOR_ATTACHMENTS: 4 };
/** Limits that every WebGL 2 has at least. */
const LEAST = {
  ...FEW_BUFFERS,
  MAX_TEXTURE_SIZE: 2048,
  MAX_RENDERBUFFER_SIZE: 2048,
  MAX_CUBE_MAP_TEXTURE_SIZE: 2048,
  MAX_TEXTURE_IMAGE_UNITS: 16,
  MAX_COMBINED_TEXTURE_IMAGE_UNITS: 32,
  MAX_VARYING_VECTORS: 15,
  MAX_FRAGMENT_UNIFORM_VECTORS: 224,
  MAX_VERTEX_UNIFORM_VECTORS: 256,
};
/** Extensions that only make drawing faster or finer. */
const EXTRAS = [
  ...['EXT_float_blend', 'OES_texture_float_linear', 'EXT_disjoint_timer_query_webgl2', 'WEBGL_multi_draw'],
  ...['EXT_texture_filter_anisotropic', 'KHR_parallel_shader_compile', 'OES_draw_buffers_indexed', 'EXT_clip_control'],
];

/** Devices by what they lack. */
export const devices = {
  nothing: {},
  // some such devices still report EXT_float_blend
  'colour buffers of whole floats': { extensions: ['EXT_color_buffer_float'] },
  'float colour buffers': { extensions: [...FLOATS, 'EXT_color_buffer_half_float'] },
  'blending of floats': { extensions: ['EXT_float_blend'] },
  'linear filtering of floats': { extensions: ['OES_texture_float_linear', 'OES_texture_half_float_linear'] },
  timers: { extensions: ['EXT_disjoint_timer_query_webgl2', 'EXT_disjoint_timer_query'] },
  'a fifth draw buffer': { limits: FEW_BUFFERS },
  'textures above 2048': { limits: { MAX_TEXTURE_SIZE: 2048, MAX_RENDERBUFFER_SIZE: 2048 } },
  'textures above 4096': { limits: { MAX_TEXTURE_SIZE: 4096, MAX_RENDERBUFFER_SIZE: 4096 } },
  'texture units above 16': { limits: { MAX_TEXTURE_IMAGE_UNITS: 16, MAX_COMBINED_TEXTURE_IMAGE_UNITS: 32 } },
  'varyings above 15': { limits: { MAX_VARYING_VECTORS: 15 } },
  'fragment uniforms above 224': { limits: { MAX_FRAGMENT_UNIFORM_VECTORS: 224 } },
  'highp in fragments': { mediump: true },
  'several draws a call': { extensions: ['WEBGL_multi_draw'] },
  'anisotropic filtering': { extensions: ['EXT_texture_filter_anisotropic'] },
  'compiling aside': { extensions: ['KHR_parallel_shader_compile'] },
  'anything above the least limits': { limits: LEAST, extensions: EXTRAS },
  'anything but WebGL 2 itself': {
    limits: LEAST,
    extensions: [...EXTRAS, ...FLOATS, 'EXT_color_buffer_half_float'],
    mediump: true,
  },
} as const satisfies Record<string, Subtraction>;

export type DeviceName = keyof typeof devices;

/**
 * Makes WebGL contexts of this page lack what the subtraction says, and notes what is done beyond its limits.
 * @returns what was done beyond them, each kind once; contexts made from now on add to it
 */
export function subtract({ extensions = [], limits = {}, mediump = false }: Subtraction): Set<string> {
  const seen = new Set<string>();
  const { prototype } = WebGL2RenderingContext;
  const gl = prototype as unknown as Record<string, number>;
  const wrap = (
    name: string,
    make: (before: (...a: any[]) => any) => (this: WebGL2RenderingContext, ...a: any[]) => any,
  ) => {
    const methods = prototype as unknown as Record<string, any>;
    methods[name] = make(methods[name]);
  };
  wrap(
    'getExtension',
    (before) =>
      function (name: string) {
        return extensions.includes(name) ? null : before.call(this, name);
      },
  );
  wrap(
    'getSupportedExtensions',
    (before) =>
      function () {
        return before.call(this)?.filter((name: string) => !extensions.includes(name)) ?? null;
      },
  );
  const values = new Map(Object.entries(limits).map(([name, value]) => [gl[name], value]));
  wrap(
    'getParameter',
    (before) =>
      function (name: number) {
        return values.get(name) ?? before.call(this, name);
      },
  );
  if (mediump)
    wrap(
      'getShaderPrecisionFormat',
      (before) =>
        function (shader: number, precision: number) {
          const least = shader === gl.FRAGMENT_SHADER && precision === gl.HIGH_FLOAT;
          return least ? { precision: 0, rangeMin: 0, rangeMax: 0 } : before.call(this, shader, precision);
        },
    );
  /** Notes a call whose value is above a limit. */
  const bound = (name: string, limit: string, valueOf: (...a: any[]) => number) => {
    const most = limits[limit];
    if (most === undefined) return;
    wrap(
      name,
      (before) =>
        function (...values: any[]) {
          const value = valueOf(...values);
          if (value > most) seen.add(`${name} with ${value} where ${limit} is ${most}`);
          return before.apply(this, values);
        },
    );
  };
  bound('drawBuffers', 'MAX_DRAW_BUFFERS', (list: number[]) => list.length);
  const attachment = (_: number, at: number) => (at - gl.COLOR_ATTACHMENT0 < 32 ? at - gl.COLOR_ATTACHMENT0 + 1 : 0);
  for (const name of ['framebufferTexture2D', 'framebufferTextureLayer', 'framebufferRenderbuffer'])
    bound(name, 'MAX_COLOR_ATTACHMENTS', attachment);
  bound('texStorage2D', 'MAX_TEXTURE_SIZE', (_t, _l, _f, w: number, h: number) => Math.max(w, h));
  bound('texImage2D', 'MAX_TEXTURE_SIZE', (_t, _l, _f, w: number, h: number, ...rest: unknown[]) =>
    rest.length > 2 ? Math.max(w, h) : 0,
  );
  bound('renderbufferStorage', 'MAX_RENDERBUFFER_SIZE', (_t, _f, w: number, h: number) => Math.max(w, h));
  bound('renderbufferStorageMultisample', 'MAX_RENDERBUFFER_SIZE', (_t, _s, _f, w: number, h: number) =>
    Math.max(w, h),
  );
  wrap('useProgram', (before) => {
    const known = new WeakSet<WebGLProgram>();
    return function (program: WebGLProgram | null) {
      before.call(this, program);
      if (program === null || known.has(program)) return;
      known.add(program);
      for (const [limit, count] of Object.entries(programSizes(this, program))) {
        if (count > (limits[limit] ?? Infinity)) seen.add(`a program of ${count} where ${limit} is ${limits[limit]}`);
      }
    };
  });
  return seen;
}

/** Resources of a program that limits count. Varyings cannot be counted: three's and Farol's shaders are linked by the driver. */
function programSizes(gl: WebGL2RenderingContext, program: WebGLProgram): Record<string, number> {
  let fragment = '';
  for (const shader of gl.getAttachedShaders(program) ?? []) {
    const type = gl.getShaderParameter(shader, gl.SHADER_TYPE) as number;
    if (type === gl.FRAGMENT_SHADER) fragment = gl.getShaderSource(shader) ?? '';
  }
  const sizes = { MAX_TEXTURE_IMAGE_UNITS: 0, MAX_FRAGMENT_UNIFORM_VECTORS: 0 };
  const count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) as number;
  for (let i = 0; i < count; i++) {
    const { name, size, type } = gl.getActiveUniform(program, i)!;
    const base = name.split(/[.[]/)[0];
    if (!new RegExp(`uniform[^;]*\\b${base}\\b`).test(fragment)) continue;
    if (SAMPLERS.has(type)) sizes.MAX_TEXTURE_IMAGE_UNITS += size;
    else sizes.MAX_FRAGMENT_UNIFORM_VECTORS += size * (ROWS[type] ?? 1);
  }
  return sizes;
}

const { prototype: GL } = WebGL2RenderingContext;
const SAMPLERS: ReadonlySet<number> = new Set([
  GL.SAMPLER_2D, GL.SAMPLER_3D, GL.SAMPLER_CUBE, GL.SAMPLER_2D_SHADOW, GL.SAMPLER_CUBE_SHADOW, GL.SAMPLER_2D_ARRAY,
  GL.SAMPLER_2D_ARRAY_SHADOW, GL.INT_SAMPLER_2D, GL.UNSIGNED_INT_SAMPLER_2D, GL.UNSIGNED_INT_SAMPLER_2D_ARRAY,
]); // prettier-ignore
const ROWS: Readonly<Record<number, number>> = { [GL.FLOAT_MAT3]: 3, [GL.FLOAT_MAT4]: 4 };
