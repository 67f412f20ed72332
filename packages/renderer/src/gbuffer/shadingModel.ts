import type { Color, Material, MeshPhongMaterial, MeshPhysicalMaterial, MeshStandardMaterial, Texture } from 'three';
import { FloatType, HalfFloatType } from 'three';
import { type ShadingModel, shadingModels, surfaceFlags } from './surfaceFlags';

type AnyMaterial = Material & {
  isMeshStandardMaterial?: boolean;
  isMeshPhysicalMaterial?: boolean;
  isMeshLambertMaterial?: boolean;
  isMeshPhongMaterial?: boolean;
  fog?: boolean;
  color?: Color;
  map?: Texture | null;
  combine?: number;
  envMap?: unknown;
};

/**
 * Shading model by which the G-buffer can hold a material without visible loss; null if it must be drawn forward. A cube map
 * blended into the lit colour, albedo above 1 and the lobes of MeshPhysicalMaterial do not fit.
 */
export function shadingModelOf(material: Material): ShadingModel | null {
  const m = material as AnyMaterial;
  if ((m.color !== undefined && exceedsOne(m.color)) || isOfFloats(m.map)) return null;
  if (m.isMeshStandardMaterial)
    return m.isMeshPhysicalMaterial && !isPlainPhysical(m as MeshPhysicalMaterial) ? null : 'standard';
  if (m.isMeshPhongMaterial) return m.envMap || exceedsOne((m as MeshPhongMaterial).specular) ? null : 'phong';
  if (m.isMeshLambertMaterial) return m.envMap ? null : 'lambert';
  return null;
}

/**
 * Whether a material fits the G-buffer but not that of the quality 'lite': its reflectance at normal incidence may differ from
 * 0.04, or its specular is coloured.
 */
export function exceedsLite(material: Material): boolean {
  const { specular, isMeshPhysicalMaterial } = material as AnyMaterial & Partial<MeshPhongMaterial>;
  if (specular) return specular.r !== specular.g || specular.g !== specular.b;
  return isMeshPhysicalMaterial === true;
}

/** Flags of a material in the G-buffer, 0 to 47. */
export function flagsOf(material: Material, model: ShadingModel): number {
  return (
    shadingModels[model] +
    ((material as AnyMaterial).fog === false ? 0 : surfaceFlags.hasFog) +
    (material.toneMapped ? surfaceFlags.isToneMapped : 0) +
    (material.dithering ? surfaceFlags.isDithered : 0)
  );
}

/** Whether a map has a float format, such as a mirror's target, so that values may exceed 1. */
function isOfFloats(map?: Texture | null): boolean {
  return map?.type === HalfFloatType || map?.type === FloatType;
}

function exceedsOne(color: Color): boolean {
  return color.r > 1 || color.g > 1 || color.b > 1;
}

type Lobes = MeshPhysicalMaterial & { dispersion?: number; retroreflectivity?: number; diffuseRoughness?: number };

/** True for physical materials that add only index of refraction and a grey specular to standard ones. */
function isPlainPhysical(material: MeshPhysicalMaterial & MeshStandardMaterial): boolean {
  const { clearcoat, sheen, iridescence, anisotropy, transmission, specularColor: s } = material;
  const { dispersion, retroreflectivity, diffuseRoughness } = material as Lobes;
  if (clearcoat || sheen || iridescence || anisotropy || transmission) return false;
  if (dispersion || retroreflectivity || diffuseRoughness) return false;
  return s.r === s.g && s.g === s.b && material.specularColorMap === null;
}
