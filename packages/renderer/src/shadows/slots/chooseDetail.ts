import { BasicShadowMap, type Camera, VSMShadowMap, type WebGLShadowMap } from 'three';
import type { PictureSize } from '../../lights/PictureSize';
import type { ShadowSlot } from './ShadowSlot';
import { sufficientDetail } from './sufficientDetail';

/**
 * Maximum number of shadow maps that a frame draws anew only because a camera needs them twice as large; maps that need
 * more do not wait.
 */
const MOST_GROWN = 4;

/**
 * Chooses the level of detail of the lit lights' maps. A map that is too coarse for a camera is larger at once; one
 * that is too fine becomes smaller in time, and only when it is drawn anew anyway: nothing is drawn again and again as
 * cameras move to and fro, or take turns.
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
  // variance shadow maps are blurred by texels, basic ones show each texel
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
