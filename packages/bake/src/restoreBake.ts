import { DataTexture, HalfFloatType, type Light, LinearFilter, RGBAFormat, type Scene, type Texture } from 'three';
import { AppliedBake } from './apply/AppliedBake';
import type { Bake, BakedLightmap } from './Bake';

/** A bake read from a file, with its meshes found in the scene again. */
export interface SavedBake extends Pick<Bake, 'meshes' | 'channel' | 'probes'> {
  /** Half floats as baked, or textures of irradiance, such as compressed ones, which the bake disposes of. */
  readonly lightmaps: readonly (BakedLightmap | Texture)[];
}

/** Options of `restoreBake`. */
export interface RestoreOptions {
  /** Lights that the lightmaps contain, switched off while the bake is applied. Default none. */
  lights?: readonly Light[];
  /**
   * Scene whose environment is baked into the lightmaps: materials then show only its mirror reflection. Default null.
   */
  skyOf?: Scene | null;
}

/** Makes a bake from the saved result of {@link bakeLightmaps}, without tracing. */
export function restoreBake(
  { lightmaps, meshes, channel, probes }: SavedBake,
  { lights = [], skyOf = null }: RestoreOptions = {},
): Bake {
  let textures: Texture[] = [];
  let applied: AppliedBake | null = null;
  return {
    lightmaps: lightmaps.filter((each): each is BakedLightmap => !('isTexture' in each)),
    ...{ meshes, channel, probes },
    get isApplied() {
      return applied?.isApplied ?? false;
    },
    apply() {
      if (!applied) {
        textures = lightmaps.map((each) => lightmapTexture(each, channel));
        applied = new AppliedBake(meshes, lights, textures, channel, skyOf);
      }
      applied.apply();
    },
    remove: () => applied?.remove(),
    dispose() {
      applied?.dispose();
      applied = null;
      for (const texture of textures) texture.dispose();
      textures = [];
    },
  };
}

function lightmapTexture(lightmap: BakedLightmap | Texture, channel: number): Texture {
  if ('isTexture' in lightmap) {
    lightmap.channel = channel;
    return lightmap;
  }
  const texture = new DataTexture(lightmap.data, lightmap.width, lightmap.height, RGBAFormat, HalfFloatType);
  texture.minFilter = texture.magFilter = LinearFilter;
  texture.channel = channel;
  texture.needsUpdate = true;
  return texture;
}
