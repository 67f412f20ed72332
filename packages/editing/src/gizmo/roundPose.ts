import type { EulerOrder } from 'three';
import { toDegrees, toRadians } from '../fields/angles';
import type { Vector3Tuple } from '../fields/Field';
import { nearestEuler } from './nearestEuler';
import type { Pose } from './TransformDrag';

/** Position, rotation (rad) and scale of an object relative to its parent, as plain numbers. */
export interface PoseValues {
  readonly position: Vector3Tuple;
  readonly rotation: Vector3Tuple;
  readonly scale: Vector3Tuple;
}

/** Significant digits kept of a drag's length, and of a scale. */
const DIGITS = 5;
/** Decimals kept of angles in degrees. */
const DEGREE_DECIMALS = 3;
/** Changes below this are rounding errors (relative to the value, or to 1). */
const NOISE = 1e-9;

/**
 * Rounds the changed numbers of a vector; unchanged ones keep all their digits.
 * @param decimals - returns the decimals to keep of a changed number
 */
const rounded = (after: Vector3Tuple, before: Vector3Tuple, decimals: (value: number) => number): Vector3Tuple =>
  after.map((value, i) => {
    if (Math.abs(value - before[i]) <= NOISE * Math.max(1, Math.abs(before[i]))) return before[i];
    return Number(value.toFixed(Math.min(Math.max(decimals(value), 0), 20))) + 0;
  }) as unknown as Vector3Tuple;

/** Number of decimals that give a value a number of significant digits. */
const decimalsOf = (value: number, digits: number): number => digits - 1 - Math.floor(Math.log10(Math.abs(value) || 1));

/**
 * Rounds the pose at the end of a drag to readable numbers: 0.8, not 0.7999999999999989. Of equivalent Euler angles,
 * those nearest to the previous ones are chosen.
 * @param before - the pose before the drag
 * @param order - order of the Euler angles
 */
export function roundPose(before: PoseValues, pose: Partial<Pose>, order: EulerOrder = 'XYZ'): Partial<PoseValues> {
  const { position, quaternion, scale } = pose;
  const far = position ? Math.max(...position.toArray().map((value, i) => Math.abs(value - before.position[i]))) : 0;
  // a drag by 1 m keeps tenths of a millimetre; a long drag keeps at least millimetres
  const decimals = Math.max(decimalsOf(far, DIGITS), 3);
  return {
    ...(position && { position: rounded(position.toArray(), before.position, () => decimals) }),
    ...(quaternion && { rotation: roundedAngles(nearestEuler(quaternion, before.rotation, order), before.rotation) }),
    ...(scale && { scale: rounded(scale.toArray(), before.scale, (value) => decimalsOf(value, DIGITS)) }),
  };
}

function roundedAngles(after: Vector3Tuple, before: Vector3Tuple): Vector3Tuple {
  const degrees = (angles: Vector3Tuple): Vector3Tuple => angles.map(toDegrees) as unknown as Vector3Tuple;
  const [from, to] = [degrees(before), degrees(after)];
  return rounded(to, from, () => DEGREE_DECIMALS).map((angle, i) =>
    angle === from[i] ? before[i] : toRadians(angle),
  ) as unknown as Vector3Tuple;
}
