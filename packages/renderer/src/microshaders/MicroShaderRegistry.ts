import type { MicroShader } from './MicroShader';

/** Holds microshaders and composes shaders of them. */
export class MicroShaderRegistry {
  private readonly chunks = new Map<string, MicroShader>();

  constructor(private readonly parent: MicroShaderRegistry | null = null) {}

  add(chunk: MicroShader): void {
    this.chunks.set(chunk.name, chunk);
  }

  get(name: string): MicroShader {
    const chunk = this.chunks.get(name) ?? this.parent?.get(name);
    if (chunk === undefined) throw new Error(`Unknown microshader "${name}".`);
    return chunk;
  }

  header(names: readonly string[]): string {
    const done = new Set<string>();
    const out: string[] = [];
    const visit = (name: string) => {
      if (done.has(name)) return;
      done.add(name);
      const chunk = this.get(name);
      chunk.dependencies.forEach(visit);
      out.push(`// <${name}>`, chunk.header);
    };
    names.forEach(visit);
    return out.join('\n');
  }

  compose(vertex: readonly string[], fragment: readonly string[]): { vertexShader: string; fragmentShader: string } {
    const one = (names: readonly string[]) =>
      `${this.header(names)}\nvoid main() {\n${names.map((name) => this.get(name).main).join('\n')}\n}\n`;
    return { vertexShader: one(vertex), fragmentShader: one(fragment) };
  }

  revision(_names: readonly string[]): number {
    return 0;
  }

  onChange(_listener: () => void): () => void {
    return () => undefined;
  }
}
