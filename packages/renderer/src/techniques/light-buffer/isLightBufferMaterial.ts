import type { Material, MeshPhysicalMaterial } from 'three';
import { exceedsGBuffer, type SharpLights } from '../../gbuffer/exceedsGBuffer';

type AnyMaterial = Material &
  Partial<Pick<MeshPhysicalMaterial, 'specularIntensity' | 'specularIntensityMap'>> & {
    isMeshStandardMaterial?: boolean;
    isMeshPhysicalMaterial?: boolean;
    isMeshLambertMaterial?: boolean;
    isMeshPhongMaterial?: boolean;
  };
type Lobes = MeshPhysicalMaterial & { retroreflectivity?: number; diffuseRoughness?: number };

/**
 * True for materials that the sums of the light buffer light without loss: Lambert, Blinn-Phong, standard, and physical with
 * iridescence, any index of refraction and any specular colour. False where each light must be shaded by itself: for a second
 * lobe (clearcoat, sheen, retroreflection), an anisotropic one, rough diffuse reflection and toon shading; for a specular
 * intensity below 1 where shaders have area lights, since both need the sum `rest`, and if too glossy for the lights.
 * @param knowsAreas - whether shaders have code for area lights. Default false
 * @param lights - kinds of lights in the frame. Default none
 */
export function isLightBufferMaterial(material: Material, knowsAreas = false, lights?: SharpLights): boolean {
  const m = material as AnyMaterial;
  if (lights && exceedsGBuffer(m, lights)) return false;
  if (m.isMeshLambertMaterial || m.isMeshPhongMaterial) return true;
  if (!m.isMeshStandardMaterial) return false;
  if (!m.isMeshPhysicalMaterial) return true;
  if (knowsAreas && (m.specularIntensity !== 1 || m.specularIntensityMap)) return false;
  const { clearcoat, sheen, anisotropy, transmission, retroreflectivity, diffuseRoughness } = m as Lobes;
  return !clearcoat && !sheen && !anisotropy && !transmission && !retroreflectivity && !diffuseRoughness;
}
