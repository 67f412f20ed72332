import type { Material, MeshStandardMaterial } from 'three';

/** Roughness below which the images of area lights have edges so sharp that rounded normals and roughness show. */
const POLISHED = 0.3;

/** Whether a material mirrors area lights too sharply for a G-buffer; a `roughnessMap` counts as white. */
export function isPolished(material: Material): boolean {
  return (material as MeshStandardMaterial).roughness < POLISHED;
}
