import { BasicShadowMap, type Camera, VSMShadowMap, type WebGLShadowMap } from 'three';
import type { PictureSize } from '../../../lighting/LightTable';
import type { ShadowSlot } from './ShadowSlot';
import { spareHalvings } from './spareHalvings';

/** Frames (of any camera) for which a map has more texels than they show, before it is halved. */
const PATIENCE = 30;
/** Eighths of a halving by which it has. */
const MARGIN = 2;
/** Maps that a frame draws anew at most since a camera needs them of twice the size; what needs more does not wait. */
const MOST_GROWN = 4;

/**
 * Finds how often the maps of local lights are to be halved since pictures show no more of them. A map that is too coarse for
 * a camera is larger at once, one that is too fine becomes smaller in time, and only when it is drawn anew anyway: nothing is
 * drawn again and again as cameras move to and fro, or take turns.
 * @param isFull the atlas; it looks at all sizes by itself then, from time to time
 */
export function settleSizes(
  slots: readonly ShadowSlot[],
  camera: Camera,
  picture: PictureSize,
  { autoUpdate, type }: WebGLShadowMap,
  isFull: boolean,
): void {
  // variance shadow maps are blurred by texels, basic ones show each
  const isFiltered = type !== VSMShadowMap && type !== BasicShadowMap;
  let grown = 0;
  for (const slot of slots) {
    const follows = autoUpdate && slot.shadow.autoUpdate;
    settle(slot, isFiltered ? spareHalvings(slot, camera, picture) : 0, follows);
    const { spare, excess, dirty } = slot;
    if (spare === excess || isFull) continue;
    const isDrawn = dirty && follows;
    if (spare > excess ? !isDrawn : spare === excess - 1 && !isDrawn && grown++ >= MOST_GROWN) continue;
    slot.excess = spare;
    slot.patience = 0;
  }
}

/**
 * Finds `spare`, and `excess` of a light that has no map yet.
 * @param eighths of halvings that this camera could spare
 * @param follows the map is drawn whenever something changes
 */
function settle(slot: ShadowSlot, eighths: number, follows: boolean): void {
  const { excess } = slot;
  const most = eighths >> 3;
  if (slot.tile === null) {
    slot.patience = 0;
    // a map that is drawn once must do for all cameras
    slot.excess = slot.spare = follows || slot.hadMap ? most : 0;
    return;
  }
  const less = follows ? (eighths - MARGIN) >> 3 : 0;
  if (less <= excess) {
    slot.patience = 0;
    slot.spare = Math.min(most, excess);
    return;
  }
  slot.least = slot.patience === 0 ? less : Math.min(slot.least, less);
  slot.patience++;
  slot.spare = slot.patience > PATIENCE ? slot.least : excess;
}
