import { BasicShadowMap, type Camera, VSMShadowMap, type WebGLShadowMap } from 'three';
import type { PictureSize } from '../../lights/PictureSize';
import type { ShadowSlot } from './ShadowSlot';
import { sufficientDetail } from './sufficientDetail';

/**
 * Maximum number of shadow maps redrawn in a frame only because a camera needs twice their size; maps that need more are always
 * redrawn.
 */
const MOST_GROWN = 4;

/**
 * Chooses the level of detail of the frame's maps. A map too coarse for a camera grows at once; one too fine shrinks after a
 * while, and only when it is redrawn anyway, so that cameras that move to and fro or alternate cause no redraws.
 * @param picture - size (pixels)
 * @param isFull - whether the atlas is full: it then revises all sizes by itself from time to time
 */
export function chooseDetail(
  slots: readonly ShadowSlot[],
  camera: Camera,
  picture: PictureSize,
  { autoUpdate, type }: WebGLShadowMap,
  isFull: boolean,
): void {
  // variance shadow maps, whose blur is in texels, and basic ones, which show each texel, keep their size
  const isFiltered = type !== VSMShadowMap && type !== BasicShadowMap;
  let grown = 0;
  for (const slot of slots) {
    const { detail, map, placement } = slot;
    const updates = autoUpdate && slot.shadow.autoUpdate;
    const eighths = isFiltered ? sufficientDetail(slot, camera, picture) : 0;
    if (placement.region === null) {
      // a map that is drawn only once must suffice for all cameras
      detail.start(updates || map.wasDrawn ? eighths >> 3 : 0);
      continue;
    }
    detail.aim(eighths, updates);
    const { level, target } = detail;
    if (target === level || isFull) continue;
    const isDrawn = map.isStale && updates;
    if (target > level ? !isDrawn : target === level - 1 && !isDrawn && grown++ >= MOST_GROWN) continue;
    detail.reach();
  }
}
