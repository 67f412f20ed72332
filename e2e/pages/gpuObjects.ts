import { atRelease } from './Bench';

/** GPU objects that are alive, by kind, from `countGpuObjects` on. */
export type GpuObjects = Record<string, number>;

const KINDS = [
  ...['Buffer', 'Framebuffer', 'Program', 'Query', 'Renderbuffer', 'Sampler', 'Shader', 'Texture'],
  ...['TransformFeedback', 'VertexArray'],
];

/**
 * Counts the objects of all WebGL contexts that are made and deleted from now on.
 * @param keepsLost - whether objects of a lost context count until they are deleted, which finds code that still holds
 *   them; else they no longer count. Default false
 * @returns function that gives their numbers
 */
export function countGpuObjects(keepsLost = false): () => GpuObjects {
  const methods = WebGL2RenderingContext.prototype as unknown as Record<string, (...a: unknown[]) => unknown>;
  const alive = new Map<unknown, Map<object, string>>();
  const of = (gl: unknown): Map<object, string> => {
    let known = alive.get(gl);
    if (known === undefined) {
      alive.set(gl, (known = new Map<object, string>()));
      if (!keepsLost)
        (gl as WebGL2RenderingContext).canvas.addEventListener('webglcontextlost', () => alive.get(gl)!.clear());
    }
    return known;
  };
  for (const kind of KINDS) {
    const { [`create${kind}`]: create, [`delete${kind}`]: remove } = methods;
    atRelease(() => Object.assign(methods, { [`create${kind}`]: create, [`delete${kind}`]: remove }));
    methods[`create${kind}`] = function (...args) {
      const made = create.apply(this, args) as object | null;
      if (made !== null && !(this as unknown as WebGL2RenderingContext).isContextLost()) of(this).set(made, kind);
      return made;
    };
    methods[`delete${kind}`] = function (...args) {
      of(this).delete(args[0] as object);
      return remove.apply(this, args);
    };
  }
  return () => {
    const counts: GpuObjects = {};
    for (const known of alive.values()) for (const kind of known.values()) counts[kind] = (counts[kind] ?? 0) + 1;
    return counts;
  };
}
