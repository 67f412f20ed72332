import { type IUniform, type Texture, Vector3 } from 'three';

/** Number of slices of depth. */
export const SLICES = 256;

/** Uniforms of lightSlice.glsl and lightLoopSlices.glsl. */
export interface FieldSlices extends Record<string, IUniform> {
  /** x: depth where the first slice begins (m); y: slices for each unit of depth; z: 1 when depths are logarithms, else 0. */
  readonly farol_fieldSlices: IUniform<Vector3>;
  readonly farol_sliceQuads: IUniform<Texture | null>;
}

export function fieldSlices(): FieldSlices {
  return { farol_fieldSlices: { value: new Vector3() }, farol_sliceQuads: { value: null } };
}
