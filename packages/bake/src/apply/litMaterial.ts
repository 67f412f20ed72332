import { Material, type MeshStandardMaterial, type Scene, type Texture } from 'three';
import type { Material as AnyMaterial } from 'three';

/** A material that has a lightmap, and follows all changes of the material that it was made from. */
export interface LitMaterial {
  readonly material: AnyMaterial;
  setLightmap(texture: Texture): void;
}

/**
 * A material that inherits every property of its source, live, and has a lightmap. Nothing is written to the source.
 *
 * @param skyOf - scene whose environment is baked into the lightmap, so the material adds only the mirror reflection of
 *   it; null when it is not baked
 */
export function litMaterial(source: AnyMaterial, texture: Texture, skyOf: Scene | null): LitMaterial {
  const lit = Object.create(source) as MeshStandardMaterial;
  const { id, uuid } = new Material();
  let ownVersion = 0;
  const own = (name: string, value: unknown): void => {
    Object.defineProperty(lit, name, { value, writable: true, configurable: true, enumerable: true });
  };
  Object.defineProperty(lit, 'id', { value: id });
  own('uuid', uuid);
  Object.defineProperty(lit, 'version', {
    get: () => source.version + ownVersion,
    set: (version: number) => {
      ownVersion = version - source.version;
    },
  });
  own('_listeners', undefined);
  own('lightMap', texture);
  own('lightMapIntensity', 1);
  if (skyOf && 'isMeshStandardMaterial' in source) {
    const standard = source as MeshStandardMaterial;
    Object.defineProperty(lit, 'envMap', { get: () => standard.envMap ?? skyOf.environment });
    Object.defineProperty(lit, 'envMapIntensity', {
      get: () => standard.metalness * (standard.envMap ? standard.envMapIntensity : skyOf.environmentIntensity),
    });
    Object.defineProperty(lit, 'envMapRotation', {
      get: () => (standard.envMap ? standard.envMapRotation : skyOf.environmentRotation),
    });
  }
  return {
    material: lit,
    setLightmap: (next) => {
      lit.lightMap = next;
    },
  };
}
