import { type Command, SetFields, t } from '@farol/editing';
import type { ClipAsset, ClipData, ComponentClass, GameObject, Scene } from '@farol/engine';
import { freeAssetName, splitName } from '../assetNames';
import { AddAssets } from '../commands/AddAssets';
import { addComponent } from '../edits';
import { Sequence } from '../commands/Sequence';
import { noteClipData, writeClip } from './clipDataOf';
import { lastTime } from './clipTracks';

/** Display name of a clip: its name without the folder. */
export const clipName = (clip: { readonly name: string }): string => splitName(clip.name).leaf;

export const durationOf = (clip: ClipAsset): number => clip.duration;

export const frameRateOf = (clip: ClipAsset): number => clip.frameRate;

/**
 * Replaces tracks and events of a clip, extending the clip when they lie beyond its end.
 * @param duration - minimum duration (s); the current one when absent
 */
export function setClip(label: string, clip: ClipAsset, data: ClipData, duration = durationOf(clip)): SetFields {
  const text = writeClip(data);
  noteClipData(clip, text, data);
  return new SetFields(label, [
    { owner: clip, name: 'data', value: text },
    { owner: clip, name: 'duration', value: Math.max(duration, lastTime(data)) },
  ]);
}

/** Sets the duration of a clip; its keys stay. */
export const setDuration = (clip: ClipAsset, duration: number): SetFields =>
  new SetFields(t('Set the duration of {name}', { name: clipName(clip) }), [
    { owner: clip, name: 'duration', value: duration },
  ]);

/**
 * Adds an empty clip, and a component that plays it when the object has none.
 * @param player - the component's class, and its field for the clip
 * @returns the command, and the clip's name
 */
export function addClip(
  scene: Scene,
  name: string,
  object: GameObject | null,
  player: { readonly type: ComponentClass; readonly field: string } | null,
): { command: Command; name: string } {
  const { assets } = scene;
  const free = freeAssetName(assets, name);
  assets.addFieldAsset('clip', free);
  const made = assets.take(free);
  const label = t('Made clip {name}', { name: free });
  const steps: (() => Command)[] = [() => new AddAssets(assets, [made])];
  if (object && player) {
    const { type, field } = player;
    const existing = object.getComponent(type.typeName);
    if (!existing) steps.push(() => addComponent(scene, [object], type, { [field]: free }));
    else if (existing.getAuthored(field) === null)
      steps.push(() => new SetFields(label, [{ owner: existing, name: field, value: free }]));
  }
  return { command: new Sequence(label, steps), name: free };
}
