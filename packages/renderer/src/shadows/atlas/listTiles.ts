import type { AtlasTile, AtlasTiles } from '../../frame/AtlasTiles';
import type { ShadowMaps } from '../ShadowMaps';
import type { AreaShadowLight } from '../slots/AreaShadowLight';
import type { LightSlots } from '../slots/LightSlots';
import type { ShadowSlot } from '../slots/ShadowSlot';

/** Lists the regions in use of an atlas. @param images - true for cookies and profiles, false for shadow maps */
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
  const host = (light as Partial<AreaShadowLight>).host ?? light;
  const count = faces.length;
  return faces.map((region, index) => ({ light: host, kind, index, count, region, camera: region.camera }));
}
