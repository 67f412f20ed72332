const kinds = [
  'Buffer',
  'Framebuffer',
  'Program',
  'Query',
  'Renderbuffer',
  'Sampler',
  'Shader',
  'Texture',
  'TransformFeedback',
  'VertexArray',
] as const;

type Gl = Record<string, (...args: unknown[]) => unknown>;

/** The objects of a canvas' WebGL context that were made and not deleted. A lost context has none. */
export class GpuObjects {
  private readonly alive = new Map<string, Set<unknown>>(kinds.map((kind) => [kind, new Set()]));

  private forgives = false;

  constructor(canvas: HTMLCanvasElement) {
    const context = canvas.getContext('webgl2', { antialias: false, stencil: false })!;
    const gl = context as unknown as Gl;
    for (const kind of kinds) {
      const alive = this.alive.get(kind)!;
      const create = gl[`create${kind}`];
      const remove = gl[`delete${kind}`];
      gl[`create${kind}`] = (...args) => {
        const made = create.apply(context, args);
        if (made && !context.isContextLost()) alive.add(made);
        return made;
      };
      gl[`delete${kind}`] = (object) => {
        if (!alive.delete(object) && this.forgives) return;
        remove.call(context, object);
      };
    }
    canvas.addEventListener('webglcontextlost', () => {
      for (const objects of this.alive.values()) objects.clear();
    });
  }

  /** While `run` runs, deletions of objects that are not alive do not reach the browser, which would warn of each. */
  forgiveLost(run: () => void): void {
    this.forgives = true;
    run();
    this.forgives = false;
  }

  get count(): number {
    let count = 0;
    for (const { size } of this.alive.values()) count += size;
    return count;
  }

  /** How many of each kind. */
  get table(): Record<string, number> {
    return Object.fromEntries([...this.alive].map(([kind, { size }]) => [kind, size]));
  }
}
