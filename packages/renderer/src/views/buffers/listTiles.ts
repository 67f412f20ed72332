import type { Camera, Light, Texture } from 'three';
import type { ShadowMaps } from '../../shadows/ShadowMaps';
import type { AreaShadowLight } from '../../shadows/slots/AreaShadowLight';
import type { LightSlots } from '../../shadows/slots/LightSlots';
import type { ShadowSlot } from '../../shadows/slots/ShadowSlot';

/** A shadow map's face, or an image, in its atlas. */
export interface AtlasTile {
  readonly light: Light | null;
  readonly kind: 'face' | 'cascade' | 'map' | 'image' | 'profile';
  /** Index of the face or cascade, from 0, and their number. */
  readonly index: number;
  readonly count: number;
  /** Rectangle (texels). */
  readonly region: Readonly<{ x: number; y: number; width: number; height: number }>;
  /** Camera of a shadow map; null for images. */
  readonly camera: Camera | null;
}

/** Contents of an atlas in a frame. */
export interface AtlasTiles {
  /** Null while nothing is drawn. */
  readonly texture: Texture | null;
  /** Contents: depths for a comparing sampler; moments of depths; colours. */
  readonly holds: 'depths' | 'moments' | 'colours';
  /** Texels a side. */
  readonly size: number;
  readonly tiles: readonly AtlasTile[];
}

/**
 * Lists what lies in an atlas in a frame.
 * @param images - whether of cookies and profiles; else of shadow maps
 */
export function listTiles({ atlases, isVariance, slots }: ShadowMaps, images: boolean): AtlasTiles {
  const inColours = images || isVariance;
  const atlas = inColours ? atlases.colours : atlases.depths;
  return {
    texture: atlases.textureOf(atlas, false),
    holds: images ? 'colours' : isVariance ? 'moments' : 'depths',
    size: atlas.size,
    tiles: images ? imagesOf(slots) : mapsOf(slots),
  };
}

/** Faces of the shadow maps that lights of the frame look up. */
function mapsOf({ lit }: LightSlots): AtlasTile[] {
  return lit.filter(({ hasShadow }) => hasShadow).flatMap(facesOf);
}

/** Images and profiles that lie in the atlas of colours, once each, with the first light that uses them. */
function imagesOf({ lit }: LightSlots): AtlasTile[] {
  const tiles = new Map<unknown, AtlasTile>();
  for (const { light, cookie, profile } of lit) {
    for (const copy of [cookie, profile]) {
      const region = copy?.placement.region ?? null;
      if (copy === null || region === null || copy.sampler >= 0 || tiles.has(copy)) continue;
      const kind = copy.isProfile ? 'profile' : 'image';
      tiles.set(copy, { light, kind, index: 0, count: 1, region, camera: null });
    }
  }
  return [...tiles.values()];
}

function facesOf({ light, faces, isCube }: ShadowSlot): AtlasTile[] {
  const kind = isCube ? 'face' : faces.length > 1 ? 'cascade' : 'map';
  return faces.map((region, index) => ({
    ...{ light: hostOf(light), kind, index, count: faces.length, region, camera: region.camera },
  }));
}

const hostOf = (light: Light): Light => (light as Partial<AreaShadowLight>).host ?? light;
