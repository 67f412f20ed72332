import type { Material, MeshStandardMaterial } from 'three';

/** Kinds of lights in a frame that some materials show too sharply for a G-buffer. */
export interface SharpLights {
  /** Whether there are area lights. */
  readonly hasAreas: boolean;
  /** Whether lights throw images. */
  readonly hasImages: boolean;
}

/** Roughness below which the images of area lights have edges so sharp that rounded normals and roughness show. */
const POLISHED = 0.3;

/**
 * Whether a material must be drawn forward under a frame's lights. One reason is that it mirrors area lights, more
 * sharply than a G-buffer's rounded normals allow (a `roughnessMap` counts as white). The other is `alphaHash` under a
 * light that throws an image: the gradients of its look-up come from neighbouring pixels, which the holes leave out.
 */
export function exceedsGBuffer(material: Material, { hasAreas, hasImages }: SharpLights): boolean {
  return (hasAreas && (material as MeshStandardMaterial).roughness < POLISHED) || (hasImages && material.alphaHash);
}
