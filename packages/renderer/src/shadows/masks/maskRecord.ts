import { BasicShadowMap, type Camera, Matrix4, type PointLight, type SpotLight, Vector3, VSMShadowMap } from 'three';
import type { DataTable } from '../../gpu/DataTable';
import { FLOATS_PER_RECORD } from '../../lights/lightRecord';
import type { PictureSize } from '../../lights/PictureSize';
import { softSizeOf } from '../slots/AreaShadowLight';
import type { ShadowSlot } from '../slots/ShadowSlot';
import { profileFrame } from './profileFrame';
import { cookieShapes, FITS, MASK, MOST_CASCADES, PLACE_BITS, shadowLookups } from './maskLayout';

const matrix = new Matrix4();
const position = new Vector3();
const across = new Vector3();
const down = new Vector3();

/**
 * Writes a light's mask record (shadow map, cookie, profile, layers), for positions in view space.
 * @param lookup - one of `shadowLookups`
 * @param reversed - whether the depth buffer is reversed
 * @param layers - layers that the light reaches, as bits; 0 for all
 * @param picture - size (pixels)
 */
export function writeMask(
  table: DataTable,
  record: number,
  slot: ShadowSlot,
  lookup: number,
  camera: Camera,
  reversed: boolean,
  layers: number,
  picture: PictureSize,
): void {
  const { cookie, isCube, near, far } = slot;
  const { region, faceWidth, faceHeight, border } = slot.placement;
  const { shadow } = slot.light;
  const at = record * FLOATS_PER_RECORD;
  if (isCube) {
    position.setFromMatrixPosition(slot.matrix).negate().applyMatrix4(camera.matrixWorldInverse);
    table.set4(at + MASK.columnX, position.x, position.y, position.z, 1);
  } else {
    // not `camera.matrixWorld`: three leaves its scale out of the view matrix
    const e = matrix.copy(camera.matrixWorldInverse).invert().premultiply(slot.matrix).elements;
    for (let i = 0; i < 16; i += 4) table.set4(at + MASK.columnX + i, e[i], e[i + 1], e[i + 2], e[i + 3]);
  }
  const height = isCube ? faceWidth : faceHeight;
  const hasCookie = cookie !== null && cookie.isThere;
  const shape = !hasCookie ? cookieShapes.none : cookie.isCube ? cookieShapes.cube : cookieShapes.map;
  const hasProfile = writeProfile(table, at, slot, shape, camera);
  const isExtended = slot.hasLeftMap || (!isCube && (height !== faceWidth || slot.cascades > 0));
  const bits = packPlace(faceWidth, lookup, hasProfile ? cookieShapes.profile : shape, isExtended, border);
  const normalBias = lookup === shadowLookups.none ? 0 : slot.normalBias;
  table.set4(at + MASK.place, region?.x ?? 0, region?.y ?? 0, bits, normalBias);
  const bias = reversed ? -shadow.bias : shadow.bias;
  const { mapSize, intensity } = shadow;
  const softSize = softSizeOf(slot.light);
  const radius = softSize > 0 ? softSize * mapSize.x : slot.filterRadius;
  const depthRange = far - near;
  const filtering = at + MASK.filtering;
  if (lookup === shadowLookups.variance) table.set4(filtering, bias, reversed ? -1 : 1, 0, intensity);
  else if (!isCube) table.set4(filtering, bias, radius / mapSize.x, radius / mapSize.y, intensity);
  else if (reversed) {
    table.set4(filtering, -near / depthRange + bias, (near * far) / depthRange, radius / mapSize.x, intensity);
  } else table.set4(filtering, far / depthRange + bias, (-near * far) / depthRange, radius / mapSize.x, intensity);
  table.set4(
    at + MASK.extent,
    height,
    slot.cascades,
    slot.hasShadow && slot.map.hasBounds && softSize === 0 ? 1 : 0,
    cookie === null ? 0 : cookie.sampler >= 0 ? -1 - cookie.sampler : cookie.filter,
  );
  const p = camera.projectionMatrix.elements;
  const span = 2 / Math.abs(p[0] * picture.width);
  writeLayers(table, at, layers, p[11] === 0 ? -span : span, 2 / Math.abs(p[5] * picture.height));
  const { cascades, fits } = slot;
  for (let i = 0; i < cascades; i++) {
    table.set4(at + FITS[i], fits[i * 4], fits[i * 4 + 1], fits[i * 4 + 2], fits[i * 4 + 3]);
  }
  if (cascades === MOST_CASCADES) return;
  if (!hasCookie || cookie.placement.region === null) table.set4(at + MASK.cookie, 0, 0, 1, 1);
  else {
    const { placement } = cookie;
    table.set4(at + MASK.cookie, placement.region!.x, placement.region!.y, placement.faceWidth, placement.faceHeight);
  }
}

/**
 * Writes a light's photometric profile into its mask record, if the profile is in the atlas.
 * @param shape - kind of the light's cookie, one of `cookieShapes`
 * @returns whether the profile was written
 */
function writeProfile(table: DataTable, at: number, slot: ShadowSlot, shape: number, camera: Camera): boolean {
  const { profile, light } = slot;
  if (profile === null || profile.placement.region === null) return false;
  const { region, faceWidth, faceHeight } = profile.placement;
  table.set4(at + MASK.profile, region.x, region.y, faceWidth, faceHeight);
  profileFrame(light as PointLight | SpotLight, across, down);
  across.transformDirection(camera.matrixWorldInverse);
  down.transformDirection(camera.matrixWorldInverse);
  table.set4(at + MASK.firstFit, across.x, across.y, across.z, shape);
  table.set4(at + MASK.secondFit, down.x, down.y, down.z, 0);
  return true;
}

/** Lookup of a light's mask, one of `shadowLookups`. @param type - of maps, as `WebGLRenderer.shadowMap.type` */
export function shadowLookupOf({ hasShadow, isCube, light }: ShadowSlot, type: number): number {
  if (!hasShadow) return shadowLookups.none;
  if (softSizeOf(light) > 0) return shadowLookups.soft;
  if (type === VSMShadowMap) return shadowLookups.variance;
  if (type === BasicShadowMap) return isCube ? shadowLookups.cubeBasic : shadowLookups.basic;
  return isCube ? shadowLookups.cubePcf : shadowLookups.pcf;
}

/** Writes the mask record of a light without shadow or cookie that does not reach all layers. */
export function writeLayerMask(table: DataTable, record: number, layers: number): void {
  const at = record * FLOATS_PER_RECORD;
  table.set4(at + MASK.place, 0, 0, packPlace(0, shadowLookups.none, cookieShapes.none, false, 1), 0);
  table.set4(at + MASK.filtering, 0, 0, 0, 0);
  table.set4(at + MASK.extent, 0, 0, 0, 0);
  writeLayers(table, at, layers);
}

/** Packs the whole number in the mask record's texel `place`. */
export function packPlace(width: number, lookup: number, shape: number, isExtended: boolean, border: number): number {
  const { lookup: lookupBit, cookie, extended, border: borderBit } = PLACE_BITS;
  const power = 31 - Math.clz32(border | 1);
  return width + (lookup << lookupBit) + (shape << cookie) + (isExtended ? 1 << extended : 0) + (power << borderBit);
}

function writeLayers(table: DataTable, at: number, layers: number, spanX = 0, spanY = 0): void {
  table.set4(at + MASK.layers, layers & 0xffff, layers >>> 16, spanX, spanY);
}
