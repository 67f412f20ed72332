import type { MicroShaderCompiler, Shader, ShaderSource } from './Shader';

type MutableShader<Program> = { -readonly [K in keyof Shader<Program>]: Shader<Program>[K] };
type Compose = (
  vertex: readonly string[],
  fragment: readonly string[],
) => { vertexShader: string; fragmentShader: string };

/** Recompiled shaders, not yet in use. */
export interface Recompiled {
  /** Puts the new programs into use and frees the old ones. */
  commit(): void;
  /** Frees the new programs; the old ones remain in use. */
  drop(): void;
}

/** The shaders of a registry by name, with their programs. */
export class ShaderCache<Program> {
  private readonly shaders = new Map<string, MutableShader<Program>>();

  constructor(
    private readonly compose: Compose,
    private readonly compiler: MicroShaderCompiler<Program> | undefined,
  ) {}

  /** @throws Error when the name belongs to other chunks already; MicroShaderCompileError when it does not compile */
  get(name: string, vertexChunks: readonly string[], fragmentChunks: readonly string[]): Shader<Program> {
    const cached = this.shaders.get(name);
    if (cached !== undefined) {
      const had = described(cached.vertexChunks, cached.fragmentChunks);
      const asked = described(vertexChunks, fragmentChunks);
      if (had === asked) return cached;
      throw new Error(`Shader "${name}" is made of ${had}, and is requested as ${asked}; give it another name.`);
    }
    const source = { name, ...this.compose(vertexChunks, fragmentChunks) };
    const shader: MutableShader<Program> = {
      ...source,
      vertexChunks: [...vertexChunks],
      fragmentChunks: [...fragmentChunks],
      program: this.compile(source),
      revision: 0,
    };
    this.shaders.set(name, shader);
    return shader;
  }

  /**
   * Composes and compiles the shaders that use any of the chunks, all of them or none.
   * @param uses - whether a shader with the given chunks has to be recompiled
   */
  recompile(uses: (chunks: readonly string[]) => boolean): Recompiled {
    const made: { shader: MutableShader<Program>; source: ShaderSource; program: Program | null }[] = [];
    const drop = () => made.forEach(({ program }) => this.release(program));
    try {
      for (const shader of this.shaders.values()) {
        if (!uses([...shader.vertexChunks, ...shader.fragmentChunks])) continue;
        const source = { name: shader.name, ...this.compose(shader.vertexChunks, shader.fragmentChunks) };
        made.push({ shader, source, program: this.compile(source) });
      }
    } catch (error) {
      drop();
      throw error;
    }
    const commit = () => {
      for (const { shader, source, program } of made) {
        this.release(shader.program);
        Object.assign(shader, source, { program, revision: shader.revision + 1 });
      }
    };
    return { commit, drop };
  }

  dispose(): void {
    for (const shader of this.shaders.values()) this.release(shader.program);
    this.shaders.clear();
  }

  private compile(source: ShaderSource): Program | null {
    return this.compiler ? this.compiler.compile(source) : null;
  }

  private release(program: Program | null): void {
    if (program !== null) this.compiler?.release?.(program);
  }
}

function described(vertex: readonly string[], fragment: readonly string[]): string {
  return `vertex [${vertex.join(', ')}], fragment [${fragment.join(', ')}]`;
}
