import { type ClipKey, type ClipTrack, valueAt } from '@farol/engine';
import type { EulerField, Vector3Field, Vector3Tuple } from '@farol/engine/fields';
import {
  Euler,
  InterpolateDiscrete,
  InterpolateLinear,
  type KeyframeTrack,
  Quaternion,
  QuaternionKeyframeTrack,
  VectorKeyframeTrack,
} from 'three';
import { beforeTime } from './beforeTime';

export interface GltfTrack {
  readonly track: KeyframeTrack;
  /** Whether a curve that glTF does not support was sampled. */
  readonly isBaked: boolean;
}

/** A value at a time, for linear or cubic interpolation. */
interface Sample {
  readonly time: number;
  readonly value: Vector3Tuple;
  /** Slopes (per second) when leaving and when reaching the value. */
  readonly out?: Vector3Tuple;
  readonly in?: Vector3Tuple;
}

const euler = new Euler();
const quaternion = new Quaternion();
const minus = (a: Vector3Tuple, b: Vector3Tuple): Vector3Tuple => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const times = (a: Vector3Tuple, factor: number): Vector3Tuple => [a[0] * factor, a[1] * factor, a[2] * factor];
const valueOf = ({ value }: ClipKey): Vector3Tuple => value as Vector3Tuple;

/** Heights of the handles of a curve that is a cubic function of time; null for others. */
function cubicOf({ easing, control }: ClipKey): readonly [number, number] | null {
  if (easing !== 'bezier') return [1 / 3, 2 / 3];
  const [x1, y1, x2, y2] = control ?? [1 / 3, 1 / 3, 2 / 3, 2 / 3];
  return Math.abs(x1 - 1 / 3) < 1e-8 && Math.abs(x2 - 2 / 3) < 1e-8 ? [y1, y2] : null;
}

/** Whether two rotations differ in one angle only, so that half of the angles is half of the rotation. */
function turnsAboutOneAxis(a: Vector3Tuple, b: Vector3Tuple): boolean {
  return [0, 1, 2].filter((i) => a[i] !== b[i]).length < 2;
}

/**
 * Converts position, rotation or scale of a clip to a track for GLTFExporter. Steps, lines, rotations about one axis,
 * and curves that are cubic in time are exact; everything else is sampled.
 * @param name - track name: node and property
 * @param field - field of a Transform
 * @param frameRate - sampling rate (Hz)
 */
export function gltfTrack(
  name: string,
  track: ClipTrack,
  field: EulerField | Vector3Field,
  frameRate: number,
): GltfTrack {
  const { keys } = track;
  const isRotation = field.kind === 'euler';
  const inner = keys.slice(0, -1);
  const make = (samples: readonly Sample[], isStep: boolean, isCubic: boolean, isBaked: boolean): GltfTrack => ({
    track: isRotation ? rotationTrack(name, samples, isStep) : vectorTrack(name, samples, isStep, isCubic),
    isBaked,
  });
  if (inner.length > 0 && inner.every(({ easing }) => easing === 'step')) {
    const steps = keys.map((key) => ({ time: key.time, value: valueOf(key) }));
    return make(steps, true, false, false);
  }
  const isCubic = !isRotation && inner.some(({ easing }) => easing === 'bezier') && inner.every(cubicOf);
  const samples: Sample[] = [];
  let isBaked = false;
  keys.forEach((key, i) => {
    const value = valueOf(key);
    const next = keys[i + 1] as ClipKey | undefined;
    const last = samples.at(-1);
    const reached = last?.out && isCubic ? incoming(keys[i - 1], key) : undefined;
    if (!next) {
      samples.push({ time: key.time, value, in: reached });
      return;
    }
    const seconds = next.time - key.time;
    const change = minus(valueOf(next), value);
    if (key.easing === 'step') {
      samples.push({ time: key.time, value, in: reached });
      samples.push({ time: beforeTime(next.time), value });
    } else if (isCubic) {
      samples.push({ time: key.time, value, in: reached, out: times(change, (3 * cubicOf(key)![0]) / seconds) });
    } else if (key.easing !== 'bezier' && (!isRotation || turnsAboutOneAxis(value, valueOf(next)))) {
      samples.push({ time: key.time, value });
      const turns = isRotation ? Math.ceil(Math.max(...change.map(Math.abs)) / (Math.PI * 0.75)) : 1;
      for (let n = 1; n < turns; n++) {
        const share = n / turns;
        const between = times(change, share);
        samples.push({
          time: key.time + seconds * share,
          value: [value[0] + between[0], value[1] + between[1], value[2] + between[2]],
        });
      }
    } else {
      isBaked = true;
      samples.push({ time: key.time, value });
      const first = Math.floor(key.time * frameRate) + 1;
      for (let frame = first; frame / frameRate < next.time; frame++) {
        const time = frame / frameRate;
        samples.push({ time, value: valueAt(track, field, time) as Vector3Tuple });
      }
    }
  });
  return make(rising(samples), false, isCubic, isBaked);
}

/** Slope (per second) with which a key is reached. */
function incoming(from: ClipKey, key: ClipKey): Vector3Tuple {
  return times(minus(valueOf(key), valueOf(from)), (3 * (1 - cubicOf(from)![1])) / (key.time - from.time));
}

/** Drops samples whose time in 32-bit floats equals that of the one before. */
const rising = (samples: readonly Sample[]): Sample[] =>
  samples.filter(({ time }, i) => i === 0 || Math.fround(time) > Math.fround(samples[i - 1].time));

const timesOf = (samples: readonly Sample[]): Float32Array => Float32Array.from(samples, ({ time }) => time);

function vectorTrack(name: string, samples: readonly Sample[], isStep: boolean, isCubic: boolean): KeyframeTrack {
  const none: Vector3Tuple = [0, 0, 0];
  const values = samples.flatMap(({ value, in: reached, out }) =>
    isCubic ? [...(reached ?? none), ...value, ...(out ?? none)] : value,
  );
  const interpolation = isStep ? InterpolateDiscrete : InterpolateLinear;
  const track = new VectorKeyframeTrack(
    name,
    timesOf(samples) as never,
    Float32Array.from(values) as never,
    interpolation,
  );
  if (isCubic) markCubic(track);
  return track;
}

/** Marks a track as a cubic spline in the way GLTFLoader does, for GLTFExporter. */
function markCubic(track: KeyframeTrack): void {
  const method = (): never => {
    throw new Error('A track that is only exported is not played.');
  };
  Object.assign(track, {
    createInterpolant: Object.assign(method, { isInterpolantFactoryMethodGLTFCubicSpline: true }),
  });
}

function rotationTrack(name: string, samples: readonly Sample[], isStep: boolean): KeyframeTrack {
  const last = new Quaternion();
  const values = samples.flatMap(({ value: [x, y, z] }, i) => {
    quaternion.setFromEuler(euler.set(x, y, z, 'XYZ'));
    // quaternions of opposite sign are the same rotation: takes the shorter way
    if (i > 0 && last.dot(quaternion) < 0) {
      quaternion.set(-quaternion.x, -quaternion.y, -quaternion.z, -quaternion.w);
    }
    last.copy(quaternion);
    return quaternion.toArray();
  });
  const interpolation = isStep ? InterpolateDiscrete : InterpolateLinear;
  return new QuaternionKeyframeTrack(
    name,
    timesOf(samples) as never,
    Float32Array.from(values) as never,
    interpolation,
  );
}
