import { type Command, SetFields, t } from '@farol/editing';
import {
  type Animation,
  type ClipData,
  type ClipKey,
  clipText,
  type ClipTrack,
  type ModelClip,
  targetOfTrack,
  whatKeepsTogether,
} from '@farol/engine';
import type { Vector3Tuple } from '@farol/engine/fields';
import { Euler, type Interpolant, InterpolateDiscrete, type KeyframeTrack, type Object3D, Quaternion } from 'three';
import { newFieldAsset } from './assetEdits';
import { splitName } from './assetNames';
import { AddAssets } from './commands/AddAssets';
import { Sequence } from './commands/Sequence';

/** A model's animation clip, converted from tracks of nodes to tracks of fields. */
export interface CopiedClip {
  readonly data: ClipData;
  /** Names of the model's tracks that cannot be converted. */
  readonly lost: readonly string[];
}

/** Maximum error of the copy between two keys: rad for rotations, else a share of the track's largest value. */
const ACCURACY = 1e-4;

/** Number of samples compared between two keys, to decide whether more keys are needed. */
const SAMPLES = 64;

const fields = { position: 'position', quaternion: 'rotation', scale: 'scale' } as const;

const euler = new Euler();
const quaternion = new Quaternion();
const other = new Quaternion();

/** Path of node names from below the model's root, as `objectsOfModel` makes them. */
function pathOf(node: Object3D, top: Object3D): string {
  const names: string[] = [];
  for (let each: Object3D | null = node; each && each !== top; each = each.parent)
    names.unshift(each.name || each.type);
  return names.join('/');
}

/** The Euler angles of a rotation that are closest to given angles. */
function nearestAngles(turn: Quaternion, near: Vector3Tuple): Vector3Tuple {
  const { x, y, z } = euler.setFromQuaternion(turn, 'XYZ');
  const rounds = (angle: number, to: number): number => angle + Math.round((to - angle) / (2 * Math.PI)) * 2 * Math.PI;
  const same = [
    [x, y, z],
    [x + Math.PI, Math.PI - y, z + Math.PI],
  ].map((angles) => angles.map((angle, i) => rounds(angle, near[i])) as unknown as Vector3Tuple);
  const distance = (angles: Vector3Tuple): number => angles.reduce((sum, angle, i) => sum + (angle - near[i]) ** 2, 0);
  return distance(same[0]) <= distance(same[1]) ? same[0] : same[1];
}

const mix = (a: Vector3Tuple, b: Vector3Tuple, share: number): Vector3Tuple => [
  a[0] + (b[0] - a[0]) * share,
  a[1] + (b[1] - a[1]) * share,
  a[2] + (b[2] - a[2]) * share,
];

/** Converts a track to keys, adding keys until linear interpolation follows the original. */
function keysOf(track: KeyframeTrack, isTurn: boolean): ClipKey[] {
  const create = (track as unknown as { createInterpolant(): Interpolant }).createInterpolant;
  const interpolant = create.call(track);
  const isStep = track.getInterpolation() === InterpolateDiscrete && !isCubic(track);
  const times = [...track.times];
  const largest = Math.max(1e-6, ...Array.from(track.values, Math.abs));
  const valueAt = (time: number, near: Vector3Tuple): Vector3Tuple => {
    const value = interpolant.evaluate(time) as ArrayLike<number>;
    if (!isTurn) return [value[0], value[1], value[2]];
    return nearestAngles(quaternion.set(value[0], value[1], value[2], value[3]).normalize(), near);
  };
  const distance = (a: Vector3Tuple, b: Vector3Tuple): number => {
    if (!isTurn) return Math.max(...a.map((each, i) => Math.abs(each - b[i]))) / largest;
    quaternion.setFromEuler(euler.set(a[0], a[1], a[2], 'XYZ'));
    other.setFromEuler(euler.set(b[0], b[1], b[2], 'XYZ'));
    return 2 * Math.acos(Math.min(1, Math.abs(quaternion.dot(other))));
  };
  const keys: ClipKey[] = [];
  const add = (time: number, value: Vector3Tuple): void => {
    keys.push(isStep ? { time, value, easing: 'step' } : { time, value });
  };
  /** Adds keys between two samples where linear interpolation errs by more than `ACCURACY`, largest error first. */
  const refine = (samples: readonly ClipKey[], first: number, last: number): void => {
    const from = samples[first].value as Vector3Tuple;
    const to = samples[last].value as Vector3Tuple;
    let farthest = first;
    let largestError = ACCURACY;
    for (let n = first + 1; n < last; n++) {
      const far = distance(samples[n].value as Vector3Tuple, mix(from, to, (n - first) / (last - first)));
      if (far <= largestError) continue;
      largestError = far;
      farthest = n;
    }
    if (farthest === first) return;
    refine(samples, first, farthest);
    add(samples[farthest].time, samples[farthest].value as Vector3Tuple);
    refine(samples, farthest, last);
  };
  times.forEach((time, i) => {
    const last = keys.at(-1);
    if (!last || isStep) {
      add(time, valueAt(time, (last?.value as Vector3Tuple | undefined) ?? [0, 0, 0]));
      return;
    }
    // samples in order of time, so that each one's angles are closest to those of the sample before
    const samples: ClipKey[] = [last];
    for (let n = 1; n <= SAMPLES; n++) {
      const at = n === SAMPLES ? time : times[i - 1] + ((time - times[i - 1]) * n) / SAMPLES;
      samples.push({ time: at, value: valueAt(at, samples[n - 1].value as Vector3Tuple) });
    }
    refine(samples, 0, SAMPLES);
    add(time, samples[SAMPLES].value as Vector3Tuple);
  });
  return keys;
}

const isCubic = (track: KeyframeTrack): boolean =>
  (track as { createInterpolant?: { isInterpolantFactoryMethodGLTFCubicSpline?: boolean } }).createInterpolant
    ?.isInterpolantFactoryMethodGLTFCubicSpline === true;

/**
 * Converts a model's clip to a clip for its unpacked objects: position, rotation and scale; morph weights are dropped.
 */
export function copyModelClip(clip: ModelClip): CopiedClip {
  const tracks: ClipTrack[] = [];
  const lost: string[] = [];
  for (const track of clip.three.tracks) {
    const target = targetOfTrack(clip, track);
    if (!target || target.property === 'morphTargetInfluences') {
      lost.push(track.name);
      continue;
    }
    const path = pathOf(target.node, clip.model.scene);
    const keys = keysOf(track, target.property === 'quaternion');
    tracks.push({ path, component: 'Transform', field: fields[target.property], keys });
  }
  return { data: { tracks, events: [] }, lost };
}

/** Why a model's clip cannot be copied for editing; null when it can. */
export const whyNotCopy = (clip: ModelClip): string | null =>
  whatKeepsTogether(clip.model) === null
    ? null
    : t(
        'Clips of skeletons and morph targets play as they are: what they move stays one object when the model is unpacked.',
      );

/**
 * Adds an editable copy of a model's clip, and makes the given Animations play the copy, as one undo step.
 * @throws Error when the clip cannot be copied
 */
export function makeEditableCopy(
  animations: readonly Animation[],
  name: string,
): { readonly command: Command; readonly name: string; readonly lost: readonly string[] } {
  const { assets } = animations[0].scene!;
  const clip = assets.clip(name);
  if (!('isModelClip' in clip)) throw new Error(t('{name} can be edited as it is.', { name }));
  const problem = whyNotCopy(clip);
  if (problem !== null) throw new Error(problem);
  const { data, lost } = copyModelClip(clip);
  const { folder } = splitName(assets.modelOf(name) ?? '');
  const baseName = clip.name.replaceAll('/', '-').trim() || t('Clip ## of an animation');
  const values = { data: clipText(data), duration: clip.duration };
  const made = newFieldAsset(assets, 'clip', folder === '' ? baseName : `${folder}/${baseName}`, values);
  const label = t('Made clip {name}', { name: made.name });
  const edits = animations.map((owner) => ({ owner, name: 'clip', value: made.name }));
  const command = new Sequence(label, [() => new AddAssets(assets, [made]), () => new SetFields(label, edits)]);
  return { command, name: made.name, lost };
}
