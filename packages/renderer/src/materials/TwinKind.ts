import type { Material, WebGLProgramParametersWithUniforms } from 'three';

/** Shader that a twin patches; the object of `Material.onBeforeCompile`. */
export type TwinShader = Pick<WebGLProgramParametersWithUniforms, 'uniforms' | 'vertexShader' | 'fragmentShader'>;

/** Purpose of a draw: write the G-buffer, shade by a light loop, or shade by the light buffer. */
export type TwinRole = 'gbuffer' | 'forward' | 'light-buffer';

/** One way in which a pass draws three's materials; a twin is made for each source material and kind. */
export interface TwinKind {
  /** Part of the program's cache key: one kind, one key. */
  readonly key: string;
  /**
   * Purpose of a draw with the twin, by which effects know what they may adapt. Default none: effects leave it as it
   * is.
   */
  readonly role?: TwinRole;
  /** Whether draws add to sums of light that an output pass writes, tone mapped and fogged. Default false. */
  readonly isSum?: boolean;
  /** Microshaders whose headers the fragment shader of a source's twin gets; a live edit of any compiles the twins anew. */
  chunks(source: Material): readonly string[];
  /** Properties that the twin has in place of its source's, such as blending. */
  readonly properties?: Partial<Material> & { fog?: boolean };
  /** Further part of the cache key, from source properties that the patch reads. */
  variant?(source: Material): string;
  /**
   * Rewrites the fragment shader; `header` is the resolved text of `chunks(source)`. Must not touch the source.
   * @throws TwinRefusal if the host's shader has no place for the patch
   */
  patch(shader: TwinShader, source: Material, header: string): void;
}
