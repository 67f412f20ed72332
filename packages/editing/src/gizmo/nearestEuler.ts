import { Euler, type EulerOrder, Quaternion, Vector3 } from 'three';
import type { Vector3Tuple } from '../fields/Field';

const TURN = 2 * Math.PI;
/** Cosine of the middle angle below which the other two rotate about one axis (gimbal lock). */
const LOCKED = 1e-6;

const euler = new Euler();
const rest = new Quaternion();
const part = new Quaternion();
const axis = new Vector3();

/** Adds whole turns to an angle (rad), so that it is nearest to another angle. */
const nearest = (angle: number, before: number): number => angle - TURN * Math.round((angle - before) / TURN);

const distance = (angles: Vector3Tuple, before: Vector3Tuple): number =>
  angles.reduce((sum, angle, i) => sum + Math.abs(angle - before[i]), 0);

/**
 * The Euler angles (rad) of a rotation that are nearest to given ones. Each rotation has many: a turn of 170° about y
 * is (0, 170, 0) and (180, 10, 180) degrees.
 * @param before - previous angles, so that a drag does not change angles needlessly
 */
export function nearestEuler(quaternion: Quaternion, before: Vector3Tuple, order: EulerOrder = 'XYZ'): Vector3Tuple {
  const { x, y, z } = euler.setFromQuaternion(quaternion, order);
  const [first, middle, last] = [...order].map((letter) => 'XYZ'.indexOf(letter));
  const found = [x, y, z];
  if (Math.abs(Math.cos(found[middle])) < LOCKED) {
    // gimbal lock: the last angle is kept, and the first compensates
    found[last] = before[last];
    const turned = (index: number): Quaternion =>
      part.setFromAxisAngle(axis.set(0, 0, 0).setComponent(index, 1), -found[index]);
    rest.copy(quaternion).multiply(turned(last)).multiply(turned(middle));
    found[first] = 2 * Math.atan2([rest.x, rest.y, rest.z][first], rest.w);
  }
  const nearestOf = (angles: readonly number[]): Vector3Tuple =>
    angles.map((angle, i) => nearest(angle, before[i])) as unknown as Vector3Tuple;
  const other = found.map((angle, i) => (i === middle ? Math.PI - angle : angle + Math.PI));
  const [a, b] = [nearestOf(found), nearestOf(other)];
  return distance(b, before) < distance(a, before) - LOCKED ? b : a;
}
