import { sphereOutsidePlanes } from '../../lights/spheres';
import type { ShadowFace } from '../slots/ShadowFace';
import type { ShadowSlot } from '../slots/ShadowSlot';
import type { Caster } from './Caster';
import { boxOutsidePlanes } from './casterBox';

/** True when a light's map may show the caster at all. */
export function isInMap(caster: Caster, slot: ShadowSlot): boolean {
  if ((caster.object.layers.mask & slot.layers) === 0) return false;
  const { x, y, z, radius, hasBox, box } = caster;
  return slot.reaches(x, y, z, radius) && (!hasBox || slot.reachesBox(box));
}

/** True when the drawn part of one face of a light's shadow map may show the caster. Call only where `isInMap` returned true. */
export function isInFace({ x, y, z, radius, hasBox, box }: Caster, face: ShadowFace): boolean {
  if (face.texels === 0) return false;
  if (radius === Infinity) return true;
  const planes = face.drawnPlanes;
  return !sphereOutsidePlanes(planes, x, y, z, radius) && !(hasBox && boxOutsidePlanes(planes, box));
}
