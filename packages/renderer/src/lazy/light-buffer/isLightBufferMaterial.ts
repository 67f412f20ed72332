import type { Material, MeshPhysicalMaterial } from 'three';

type AnyMaterial = Material & {
  isMeshStandardMaterial?: boolean;
  isMeshPhysicalMaterial?: boolean;
  isMeshLambertMaterial?: boolean;
  isMeshPhongMaterial?: boolean;
};
type Lobes = MeshPhysicalMaterial & { retroreflectivity?: number; diffuseRoughness?: number };

/**
 * True for materials that the sums of the light buffer light without loss: Lambert, Blinn-Phong, standard, and physical
 * with iridescence, any index of refraction and any specular colour. A second lobe (clearcoat, sheen, retroreflection),
 * an anisotropic one, rough diffuse reflection and toon shading need each light by itself.
 */
export function isLightBufferMaterial(material: Material): boolean {
  const m = material as AnyMaterial;
  if (m.isMeshLambertMaterial || m.isMeshPhongMaterial) return true;
  if (!m.isMeshStandardMaterial) return false;
  if (!m.isMeshPhysicalMaterial) return true;
  const { clearcoat, sheen, anisotropy, transmission, retroreflectivity, diffuseRoughness } = m as Lobes;
  return !clearcoat && !sheen && !anisotropy && !transmission && !retroreflectivity && !diffuseRoughness;
}
