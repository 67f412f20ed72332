import type { Material } from 'three';

/** Evaluation of light over a triangle: once, at its corners, or in each pixel. */
export type ShadingName = 'flat' | 'gouraud' | 'phong';

/** Shading of a material set by `setShading`; undefined for none. */
export const shadingOf = (material: Material): ShadingName | undefined =>
  (material.userData.farol as { shading?: ShadingName } | undefined)?.shading;

/** Whether a material's lights are evaluated at vertices. Never for toon materials. */
export const isGouraud = (material: Material): boolean =>
  shadingOf(material) === 'gouraud' && !(material as Material & { isMeshToonMaterial?: boolean }).isMeshToonMaterial;
