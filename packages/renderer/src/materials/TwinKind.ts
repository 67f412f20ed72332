import type { Material, WebGLProgramParametersWithUniforms } from 'three';

/** Shader that a twin patches; the object of `Material.onBeforeCompile`. */
export type TwinShader = Pick<WebGLProgramParametersWithUniforms, 'uniforms' | 'vertexShader' | 'fragmentShader'>;

/** Purpose of a draw: write the G-buffer, shade by a light loop, or shade by the light buffer. */
export type TwinRole = 'gbuffer' | 'forward' | 'light-buffer';

/** A way in which a pass draws three's materials; each source material has a twin for each kind. */
export interface TwinKind {
  /** Part of the program's cache key, unique for each kind. */
  readonly key: string;
  /** Purpose of a draw with the twin, by which effects decide whether to adapt it. Default none: not adapted. */
  readonly role?: TwinRole;
  /** Whether draws add to sums of light, which an output pass then tone maps and fogs. Default false. */
  readonly isSum?: boolean;
  /** Microshaders whose headers are added to the fragment shader of a source's twin; a live edit of any recompiles the twins. */
  chunks(source: Material): readonly string[];
  /** Properties that override the source's, such as blending. */
  readonly properties?: Partial<Material> & { fog?: boolean };
  /** Additional part of the cache key, from properties of the source that the patch reads. */
  variant?(source: Material): string;
  /**
   * Rewrites the fragment shader; `header` is the resolved text of `chunks(source)`. Must not touch the source.
   * @throws TwinRefusal if the patch cannot be inserted in the host's shader
   */
  patch(shader: TwinShader, source: Material, header: string): void;
}
