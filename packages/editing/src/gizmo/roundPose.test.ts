import { Euler, type EulerOrder, Quaternion, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { toDegrees, toRadians } from '../fields/angles';
import type { Vector3Tuple } from '../fields/Field';
import { nearestEuler } from './nearestEuler';
import { type PoseValues, roundPose } from './roundPose';

const still: PoseValues = { position: [0, 0, 0], rotation: [0, 0, 0], scale: [1, 1, 1] };
const turnOf = (angles: Vector3Tuple, order: EulerOrder = 'XYZ'): Quaternion =>
  new Quaternion().setFromEuler(new Euler(...angles, order));
const degrees = (angles: Vector3Tuple): number[] => angles.map((angle) => Math.round(toDegrees(angle) * 1e4) / 1e4 + 0);

describe('angles that are nearest to those before', () => {
  it('goes on beyond a right angle about y', () => {
    for (const angle of [10, 89, 90, 91, 170.955, 180]) {
      const found = nearestEuler(turnOf([0, toRadians(angle), 0]), [0, toRadians(angle - 5), 0]);
      expect(degrees(found)).toEqual([0, angle, 0]);
    }
    // relative to the start of the drag
    expect(degrees(nearestEuler(turnOf([0, toRadians(170.955), 0]), [0, 0, 0]))).toEqual([0, 170.955, 0]);
  });

  it('goes on beyond a whole turn', () => {
    expect(degrees(nearestEuler(turnOf([toRadians(190), 0, 0]), [toRadians(179), 0, 0]))).toEqual([190, 0, 0]);
  });

  it.each(['XYZ', 'YXZ', 'ZXY', 'ZYX', 'YZX', 'XZY'] as const)('is the same rotation, in order %s', (order) => {
    let state = 7;
    const random = (): number => ((state = (state * 16807) % 2147483647) / 2147483647 - 0.5) * 12;
    for (let i = 0; i < 300; i++) {
      const angles: Vector3Tuple = [random(), i % 3 === 0 ? (Math.PI / 2) * Math.sign(random()) : random(), random()];
      const before: Vector3Tuple = [random(), random(), random()];
      const wanted = turnOf(angles, order);
      const found = nearestEuler(wanted, before, order);
      expect(turnOf(found, order).angleTo(wanted)).toBeLessThan(1e-6);
      // no angle is a whole turn off, and the nearer of two equivalent forms is chosen
      expect(Math.max(...found.map((angle, axis) => Math.abs(angle - before[axis])))).toBeLessThan(3 * Math.PI);
    }
  });

  it('leaves angles as they are that describe the rotation already', () => {
    const angles: Vector3Tuple = [0.3, Math.PI / 2, -0.4];
    nearestEuler(turnOf(angles), angles).forEach((angle, i) => expect(angle).toBeCloseTo(angles[i], 6));
  });
});

describe('what a drag leads to', () => {
  it('is written as one would type it', () => {
    const position = new Vector3(-0.7999999999999989, 1.2345678, 1e-17);
    expect(roundPose(still, { position }).position).toEqual([-0.8, 1.2346, 0]);
    expect(roundPose(still, { quaternion: turnOf([0, toRadians(170.9551), 0]) }).rotation).toEqual([
      ...[0, toRadians(170.955), 0],
    ]);
    expect(roundPose(still, { scale: new Vector3(1.00000000001, 0.123456789, 12.3456789) }).scale).toEqual([
      ...[1, 0.12346, 12.346],
    ]);
  });

  it('keeps what it does not change, to the last digit', () => {
    const before: PoseValues = { position: [0.123456789, 2, 3], rotation: [0.123456789, 0, 1e-7], scale: [1, 2, 3] };
    const position = new Vector3(0.12345678900000001, 2.5, 3);
    expect(roundPose(before, { position }).position).toEqual([0.123456789, 2.5, 3]);
    expect(roundPose(before, { quaternion: turnOf(before.rotation) }).rotation).toEqual(before.rotation);
    expect(roundPose(before, {})).toEqual({});
  });

  it('goes finer where the drag is small', () => {
    expect(roundPose(still, { position: new Vector3(0.00123456789, 0, 0) }).position).toEqual([0.0012346, 0, 0]);
    expect(roundPose(still, { position: new Vector3(12345.6789012, 0, 0) }).position).toEqual([12345.679, 0, 0]);
  });
});
