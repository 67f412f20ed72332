import type { Material } from 'three';

/** How light is evaluated over a triangle: once, at its corners, or in each pixel. */
export type ShadingName = 'flat' | 'gouraud' | 'phong';

/** The shading that `setShading` gave a material; undefined for none. */
export const shadingOf = (material: Material): ShadingName | undefined =>
  (material.userData.farol as { shading?: ShadingName } | undefined)?.shading;

/** Whether lights are evaluated at the vertices of what has a material. Toon shading is in pixels alone. */
export const isGouraud = (material: Material): boolean =>
  shadingOf(material) === 'gouraud' && !(material as Material & { isMeshToonMaterial?: boolean }).isMeshToonMaterial;
