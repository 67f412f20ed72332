import { Color, DataTexture, type IUniform, type Texture, Vector2, Vector3, Vector4, type WebGLRenderer } from 'three';
import { MicroShaderCompileError } from '../microshaders/MicroShaderCompileError';
import type { MicroShader } from '../microshaders/MicroShader';
import type { MicroShaderRegistry } from '../microshaders';
import { addMicroShaders } from '../microshaders/addMicroShaders';
import { hashText } from '../microshaders/hashText';
import * as sources from './chunks';
import { parseSurface, type ParsedSurface } from './parseSurface';
import { probeSurface } from './probeSurface';
import type { SurfaceUniform } from './SurfaceUniform';

/** Values of a surface's uniforms. */
export type SurfaceValue = number | boolean | Color | Vector2 | Vector3 | Vector4 | Texture | null;
/** Values of the declared uniforms, by name. */
export type SurfaceValues = Readonly<Record<string, SurfaceValue | readonly number[]>>;

/** Parts of a FarolRenderer that a surface needs for compiling. */
export interface SurfaceRenderer {
  readonly webgl: WebGLRenderer;
  readonly microshaders: MicroShaderRegistry;
}

/** Options of the constructor of Surface. */
export interface SurfaceOptions {
  /** Time (s) passed to the surface's GLSL functions, in an object that surfaces may share. Default a new object. */
  readonly time?: IUniform<number>;
}

let count = 0;
let white: DataTexture | null = null;

/** Makes the white texture for texture uniforms that are not set. */
function whiteTexture(): DataTexture {
  if (white === null) {
    white = new DataTexture(new Uint8Array([255, 255, 255, 255]));
    white.needsUpdate = true;
  }
  return white;
}

/**
 * GLSL that changes the look of the materials that use it, in every technique, see `setSurface`.
 * `void surface(inout SurfaceData s)` changes a pixel's colour, normal, roughness, metalness, emissive light and opacity,
 * `void displace(inout VertexData v)` a vertex's position and normal. `#include "name"` inserts a microshader of the renderer.
 * Materials with the same surface share programs; each material has its own values of the uniforms.
 * @see thesis 3.1.2
 */
export class Surface {
  /** Number, unique on the page, in the GLSL names and chunks of the surface. */
  readonly id = ++count;
  /** Time (s) passed to the surface's GLSL functions; set it in each frame for animated surfaces. */
  readonly time: IUniform<number>;
  /** Number of edits of the surface's GLSL text. */
  version = 0;
  private text: string;
  private read: ParsedSurface;
  private hash: string;
  private sourceInUse: string;
  /** Registries that hold the surface's chunks, and for each whether the surface's text compiles with it. */
  private readonly registries = new Map<
    MicroShaderRegistry,
    { readonly gl: WebGL2RenderingContext; isUsable: boolean }
  >();

  /**
   * @param name - name in errors and lists
   * @param source - GLSL text of the surface
   * @throws MicroShaderCompileError with line, for a text without a hook or with an invalid uniform; errors of the driver are
   *   reported by the first draw, or by `compile`
   */
  constructor(name: string, source: string, options: SurfaceOptions = {}) {
    this.sourceInUse = name;
    this.time = options.time ?? { value: 0 };
    this.text = source;
    this.read = parseSurface(name, source, this.prefix);
    this.hash = hashText(source);
  }

  get name(): string {
    return this.sourceInUse;
  }

  set name(name: string) {
    this.sourceInUse = name;
  }

  /** Prefix of the surface's GLSL names in shaders. */
  get prefix(): string {
    return `farol_s${this.id}_`;
  }

  /** Names of the surface's chunks in registries, for pixels and for vertices. */
  get chunk(): string {
    return `surface/${this.id}`;
  }

  get vertexChunk(): string {
    return `surface/${this.id}/vertex`;
  }

  /** Uniforms that the surface declares. */
  get uniforms(): readonly SurfaceUniform[] {
    return this.read.uniforms;
  }

  /** Whether the surface moves vertices: objects may then leave the bounds of their geometry. */
  get displaces(): boolean {
    return this.read.displaces;
  }

  /** @internal Parsed GLSL text of the surface. */
  get parsed(): ParsedSurface {
    return this.read;
  }

  /** Part of programs' cache keys, different for each GLSL text of the surface. */
  get key(): string {
    return `${this.id}-${this.hash}`;
  }

  get source(): string {
    return this.text;
  }

  /**
   * Replaces the surface's GLSL text for all materials; programs are recompiled at their next draw. If this throws, nothing
   * changes: the last good text remains in use.
   * @throws MicroShaderCompileError with `entries` by line
   */
  set source(source: string) {
    if (source === this.text) return;
    const read = parseSurface(this.name, source, this.prefix);
    const before = this.chunksOf(this.read);
    const next = this.chunksOf(read);
    const done: (readonly [MicroShaderRegistry, MicroShader])[] = [];
    try {
      for (const [registry, { gl, isUsable }] of this.registries) {
        if (!gl.isContextLost()) probeSurface(gl, registry, next, this.prefix);
        next.forEach((chunk, i) => {
          if (isUsable) {
            registry.replace(chunk.name, chunk);
            done.push([registry, before[i]]);
          } else registry.swap(chunk.name, chunk);
        });
      }
    } catch (error) {
      for (const [registry, chunk] of done.toReversed()) registry.replace(chunk.name, chunk);
      throw this.named(error);
    }
    for (const held of this.registries.values()) held.isUsable = true;
    this.text = source;
    this.read = read;
    this.hash = hashText(source);
    this.version++;
  }

  /** Default of a uniform, as a new object; for textures a shared white one. */
  static defaultOf(uniform: SurfaceUniform): SurfaceValue {
    const { default: value, type, isColor } = uniform;
    if (value === null) return whiteTexture();
    if (typeof value !== 'object') return value;
    const [x, y, z = 0, w = 0] = value;
    if (type === 'vec2') return new Vector2(x, y);
    if (type === 'vec4') return new Vector4(x, y, z, w);
    return isColor ? new Color().setRGB(x, y, z) : new Vector3(x, y, z);
  }

  /**
   * Compiles the surface for a renderer, before it is drawn.
   * @throws MicroShaderCompileError with `entries` by line; Error for an unknown include. Materials are then drawn without the
   *   surface
   */
  compile({ webgl, microshaders }: SurfaceRenderer): void {
    const problem = this.addTo(microshaders, webgl);
    if (problem) throw problem;
  }

  /**
   * @internal Adds the surface's chunks to a registry.
   * @returns the error there, reported once; null when the surface can be drawn or the error was reported
   */
  addTo(registry: MicroShaderRegistry, webgl: WebGLRenderer): Error | null {
    if (this.registries.has(registry)) return null;
    const gl = webgl.getContext() as WebGL2RenderingContext;
    if (gl.isContextLost()) return null;
    addMicroShaders(registry, 'surfaces', sources);
    const chunks = this.chunksOf(this.read);
    const held = { gl, isUsable: false };
    this.registries.set(registry, held);
    registry.add(chunks);
    try {
      probeSurface(gl, registry, chunks, this.prefix);
      held.isUsable = true;
      return null;
    } catch (error) {
      return this.named(error);
    }
  }

  /** @internal Whether a registry holds the surface, and its text compiles there. */
  isUsable(registry: MicroShaderRegistry): boolean {
    return this.registries.get(registry)?.isUsable === true;
  }

  private chunksOf({ fragment, vertex }: ParsedSurface): MicroShader[] {
    const chunk = (name: string, stage: 'vertex' | 'fragment', header: string): MicroShader => ({
      name,
      stage,
      header: `${header}\n`,
      main: '',
      dependencies: ['surfaceData'],
    });
    return [chunk(this.chunk, 'fragment', fragment), chunk(this.vertexChunk, 'vertex', vertex)];
  }

  /** Rewrites an error in terms of the surface's text: the surface's name in place of its chunks', GLSL names without the prefix. */
  private named(error: unknown): Error {
    if (!(error instanceof MicroShaderCompileError)) return error instanceof Error ? error : new Error(String(error));
    const entries = error.entries.map((entry) => {
      const own = entry.chunk === this.chunk || entry.chunk === this.vertexChunk;
      return {
        ...entry,
        chunk: own ? this.name : entry.chunk,
        message: entry.message.replaceAll(this.prefix, ''),
        text: own ? entry.text.replaceAll(this.prefix, '') : entry.text,
      };
    });
    const seen = new Set<string>();
    return SurfaceCompileError.of(
      this.name,
      error.stage,
      entries.filter((entry) => {
        const key = `${entry.chunk}:${entry.line}:${entry.message}`;
        return !seen.has(key) && seen.add(key);
      }),
    );
  }
}

/** A driver's error, rewritten in terms of a surface's text. */
class SurfaceCompileError extends MicroShaderCompileError {
  static of(
    name: string,
    stage: MicroShaderCompileError['stage'],
    entries: MicroShaderCompileError['entries'],
  ): MicroShaderCompileError {
    const error = new SurfaceCompileError(name, stage, '', '');
    const what = entries.map(
      ({ line, message, text }) => `line ${line}: ${message}${text === '' ? '' : `\n    ${text}`}`,
    );
    error.message = `Surface "${name}" does not compile:\n  ${what.join('\n  ')}`;
    return Object.assign(error, { entries });
  }
}
