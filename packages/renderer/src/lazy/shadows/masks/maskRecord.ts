import { BasicShadowMap, type Camera, Matrix4, Vector3, VSMShadowMap } from 'three';
import type { DataTable } from '../../../gpu/DataTable';
import { FLOATS_PER_RECORD } from '../../../lights/lightRecord';
import type { ShadowSlot } from '../slots/ShadowSlot';

/**
 * A mask in the light table: what a shadow map and a cookie let through of a light. Three records of four texels:
 *
 * | texel | holds |
 * |---|---|
 * | 0–3 | columns of the matrix from view space to the map (0 to 1, depth 0 to 1); of a cube: position of the light in view space (m), 1, and nothing |
 * | 4 | corner of the tile of the shadow map (texels); width of a face, kind of shadow (`shadowLookups`), kind of cookie (0 none, 1 map, 2 cube), whether texel 6 counts (of a cube: texel 0, since the light has left its map) and the power of two of a cube's border, as bits 0–14, 15–17, 18–19, 20 and 21–23; normal bias (m) |
 * | 5 | of a map: bias (with the sign of the depth buffer), radius of the filter as part of the width, of the height; of a cube: a and b of depth = a + b / distance along an axis, radius of the filter as part of a face; intensity |
 * | 6 | of a map: its height (texels), how many nearer maps there are; 1 if the bounds of its depths are known; – |
 * | 7 | – |
 * | 8 | tile of the cookie: corner, size (texels); of a cube: corner, side of a face; else as 10 |
 * | 9 | layers that the light reaches, 16 bits and 16 bits, 0 for all; –, – |
 * | 10, 11 | how coordinates of the map become those of a nearer map: scale, shift of x; of y |
 */
export const RECORDS_PER_MASK = 3;

/** Nearer maps that a directional light has at most, and where in the mask they are. */
export const MOST_CASCADES = 3;
const CASCADES = [40, 44, 32];

/** What a mask does with its shadow map; as in lightShadow.glsl. */
export const shadowLookups = { none: 0, basic: 1, pcf: 2, cubeBasic: 3, cubePcf: 4, vsm: 5 } as const;

const matrix = new Matrix4();
const position = new Vector3();

/**
 * Writes the mask of a light, for positions in view space.
 * @param kind of its shadow, one of `shadowLookups`
 * @param reversed the depth buffer is
 * @param layers that the light reaches, as a mask; 0 for all
 */
export function writeMask(
  table: DataTable,
  record: number,
  slot: ShadowSlot,
  kind: number,
  camera: Camera,
  reversed: boolean,
  layers: number,
): void {
  const { cookie, isCube, near, far } = slot;
  const { region, faceWidth, faceHeight, border } = slot.placement;
  const { shadow } = slot.light;
  const at = record * FLOATS_PER_RECORD;
  if (isCube) {
    position.setFromMatrixPosition(slot.matrix).negate().applyMatrix4(camera.matrixWorldInverse);
    table.set4(at, position.x, position.y, position.z, 1);
  } else {
    const e = matrix.multiplyMatrices(slot.matrix, camera.matrixWorld).elements;
    for (let i = 0; i < 16; i += 4) table.set4(at + i, e[i], e[i + 1], e[i + 2], e[i + 3]);
  }
  const height = isCube ? faceWidth : faceHeight;
  const cookieKind = cookie === null || cookie.placement.region === null ? 0 : cookie.isCube ? 2 : 1;
  const extended = slot.hasLeftMap || (!isCube && (height !== faceWidth || slot.cascades > 0));
  const bits = packMask(faceWidth, kind, cookieKind, extended, border);
  table.set4(at + 16, region?.x ?? 0, region?.y ?? 0, bits, kind === shadowLookups.none ? 0 : slot.normalBias);
  const bias = reversed ? -shadow.bias : shadow.bias;
  const { mapSize, intensity } = shadow;
  const radius = slot.filterRadius;
  const depthRange = far - near;
  if (!isCube) table.set4(at + 20, bias, radius / mapSize.x, radius / mapSize.y, intensity);
  else if (reversed) {
    table.set4(at + 20, -near / depthRange + bias, (near * far) / depthRange, radius / mapSize.x, intensity);
  } else table.set4(at + 20, far / depthRange + bias, (-near * far) / depthRange, radius / mapSize.x, intensity);
  table.set4(at + 24, height, slot.cascades, slot.hasShadow && slot.map.hasBounds ? 1 : 0, 0);
  writeLayers(table, record, layers);
  const { cascades, fits } = slot;
  for (let i = 0; i < cascades; i++) {
    table.set4(at + CASCADES[i], fits[i * 4], fits[i * 4 + 1], fits[i * 4 + 2], fits[i * 4 + 3]);
  }
  if (cascades === MOST_CASCADES) return;
  if (cookieKind === 0) table.set4(at + 32, 0, 0, 1, 1);
  else {
    const { region, faceWidth, faceHeight } = cookie!.placement;
    table.set4(at + 32, region!.x, region!.y, faceWidth, faceHeight);
  }
}

/** What a light's mask does with its map. @param type of shadow maps, as `WebGLRenderer.shadowMap.type` has it */
export function shadowLookupOf({ hasShadow, isCube }: ShadowSlot, type: number): number {
  if (!hasShadow) return shadowLookups.none;
  if (type === VSMShadowMap) return shadowLookups.vsm;
  if (type === BasicShadowMap) return isCube ? shadowLookups.cubeBasic : shadowLookups.basic;
  return isCube ? shadowLookups.cubePcf : shadowLookups.pcf;
}

/** Writes the mask of a light that has neither shadow nor cookie, but does not reach all layers. */
export function writeLayerMask(table: DataTable, record: number, layers: number): void {
  table.set4(record * FLOATS_PER_RECORD + 16, 0, 0, packMask(0, shadowLookups.none, 0, false, 1), 0);
  table.set4(record * FLOATS_PER_RECORD + 20, 0, 0, 0, 0);
  table.set4(record * FLOATS_PER_RECORD + 24, 0, 0, 0, 0);
  writeLayers(table, record, layers);
}

function packMask(width: number, kind: number, cookie: number, extended: boolean, border: number): number {
  return width + (kind << 15) + (cookie << 18) + (extended ? 1 << 20 : 0) + ((31 - Math.clz32(border | 1)) << 21);
}

function writeLayers(table: DataTable, record: number, layers: number): void {
  table.set4(record * FLOATS_PER_RECORD + 36, layers & 0xffff, layers >>> 16, 0, 0);
}
