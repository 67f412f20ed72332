/** GLSL types of a surface's uniforms. */
export type SurfaceUniformType = 'float' | 'int' | 'bool' | 'vec2' | 'vec3' | 'vec4' | 'sampler2D';

/** A uniform that a surface declares, with its default and range for editors. */
export interface SurfaceUniform {
  readonly name: string;
  readonly type: SurfaceUniformType;
  /** True for a vec3 that is a colour: linear in the API, #rrggbb (sRGB) in the surface's text. */
  readonly isColor: boolean;
  /** Default value: a number, a boolean, the numbers of a vector, or null for a texture. */
  readonly default: number | boolean | readonly number[] | null;
  readonly min?: number;
  readonly max?: number;
  readonly step?: number;
  readonly label: string;
  /** Line of the declaration in the surface's text, from 1. */
  readonly line: number;
}
