import type { Material } from 'three';
import type { ShadingName } from './shadingOf';

/**
 * Sets the shading of a lit material, with every technique; may be changed at any time. Stock three ignores it. Stored at
 * `material.userData.farol.shading`.
 * - `'phong'`, the default: normals are interpolated, and light is evaluated in each pixel.
 * - `'flat'`: one normal for each triangle, as by `flatShading`.
 * - `'gouraud'`: light is evaluated at the vertices, and interpolated. Drawn forward with each technique; every vertex is
 *   lit by all lights of the table, including those of a LightField and area lights, with shadow maps, cookies and
 *   profiles, by the material's roughness or shininess without maps. Coats, sheen and the like reflect only indirect light.
 * @param shading - null for the default: `'phong'`, or flat by the material's own `flatShading`
 */
export function setShading(material: Material, shading: ShadingName | null): void {
  const { shading: _, ...others } = (material.userData.farol ?? {}) as { shading?: ShadingName };
  const data = shading === null ? others : { ...others, shading };
  if (Object.keys(data).length > 0) material.userData.farol = data;
  else delete material.userData.farol;
}
