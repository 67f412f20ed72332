import type { Material, Texture } from 'three';
import { derivedMaterial } from '../../assets/derivedMaterial';

/**
 * A material with a lightmap that inherits all else, live, from `source`, which is not changed.
 * @param lightmap - its `channel` selects the UV set
 */
export function lightmappedMaterial(source: Material, lightmap: Texture): Material {
  return derivedMaterial(source, { lightMap: lightmap, lightMapIntensity: 1 });
}

/** Whether a material supports a lightmap. */
export const takesLightmap = (material: Material): boolean => 'lightMap' in material;
