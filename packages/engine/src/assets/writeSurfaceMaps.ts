import type { SurfaceUniform, SurfaceUniforms } from '@farol/renderer/surfaces';
import type { Texture } from 'three';
import type { surfaceCode } from './surfaceCode';

/** Source of textures: an AssetLibrary. */
export interface TextureHost {
  isReady(type: 'texture', name: string): boolean;
  whenReady(type: 'texture', name: string, callback: () => void): void;
  texture(name: string): Texture;
}

/**
 * Writes the textures of a surface to its uniforms: textures of the library that are loaded, else the surface's
 * defaults.
 * @param maps - names in the order in which the surface declares its textures; null for none
 * @param again - called once a missing texture is loaded
 */
export function writeSurfaceMaps(
  code: NonNullable<(typeof surfaceCode)['code']>,
  uniforms: readonly SurfaceUniform[],
  values: SurfaceUniforms,
  maps: readonly (string | null)[],
  host: TextureHost,
  again: () => void,
): void {
  let i = 0;
  for (const uniform of uniforms) {
    if (uniform.type !== 'sampler2D') continue;
    const name = maps[i++] ?? null;
    const isReady = name !== null && host.isReady('texture', name);
    if (name !== null && !isReady) host.whenReady('texture', name, again);
    values[uniform.name].value = isReady ? host.texture(name) : code.Surface.defaultOf(uniform);
  }
}
