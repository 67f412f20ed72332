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
 * Whether a material is to be drawn forward under a frame's lights: it mirrors area lights too sharply for rounded
 * normals (a `roughnessMap` counts as white), or an image falls on `alphaHash`, whose holes leave a G-buffer without the
 * neighbours that gradients are taken from, on it and on what is seen through it.
 */
export function exceedsGBuffer(material: Material, { hasAreas, hasImages }: SharpLights): boolean {
  return (hasAreas && (material as MeshStandardMaterial).roughness < POLISHED) || (hasImages && material.alphaHash);
}
