import type { Material, MeshStandardMaterial } from 'three';

/** Kinds of lights in a frame that some materials reflect too sharply for a G-buffer. */
export interface SharpLights {
  /** Whether there are area lights. */
  readonly hasAreas: boolean;
  /** Whether any light projects an image. */
  readonly hasImages: boolean;
}

/** Roughness below which reflections of area lights are so sharp that rounded normals and roughness are visible. */
const POLISHED = 0.3;

/**
 * Whether a material must be drawn forward under a frame's lights. One reason: it reflects area lights more sharply than a
 * G-buffer's rounded normals allow (a `roughnessMap` counts as white). The other: `alphaHash` under a light that projects an
 * image, whose texture gradients come from neighbouring pixels, which may be holes.
 */
export function exceedsGBuffer(material: Material, { hasAreas, hasImages }: SharpLights): boolean {
  return (hasAreas && (material as MeshStandardMaterial).roughness < POLISHED) || (hasImages && material.alphaHash);
}
