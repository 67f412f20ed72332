import type { Material } from 'three';
import type { ShadingName } from './shadingOf';

/**
 * Chooses how a lit material is shaded, by every technique; nothing else of the material changes, and stock three does not
 * look at it. It may be changed at any time. Kept at `material.userData.farol.shading`.
 *
 * - `'phong'`, as without: normals are interpolated, and light is evaluated in each pixel.
 * - `'flat'`: one normal for each triangle, as by `flatShading`.
 * - `'gouraud'`: light is evaluated at the vertices, and interpolated. Drawn forward within each technique; every vertex goes
 *   through all lights of the table, those of a LightField and area lights among them, with shadow maps, cookies and
 *   profiles, by the material's own roughness or shininess without maps. Coats, sheen and the like take only indirect light.
 * @param shading - null for `'phong'`, or what the material's own `flatShading` says
 */
export function setShading(material: Material, shading: ShadingName | null): void {
  const { shading: _, ...others } = (material.userData.farol ?? {}) as { shading?: ShadingName };
  const data = shading === null ? others : { ...others, shading };
  if (Object.keys(data).length > 0) material.userData.farol = data;
  else delete material.userData.farol;
}
