import type { Material, Texture } from 'three';
import { derivedMaterial } from '../../assets/derivedMaterial';

/**
 * A material with a lightmap: all else it has from another one, live, which is not changed.
 * @param lightmap - its `channel` says which texture coordinates are meant
 */
export function lightmappedMaterial(source: Material, lightmap: Texture): Material {
  return derivedMaterial(source, { lightMap: lightmap, lightMapIntensity: 1 });
}

/** Whether a material shows a lightmap. */
export const takesLightmap = (material: Material): boolean => 'lightMap' in material;
