import type { FieldValue } from '@farol/editing/fields';
import '../index';
import type { ClipData, ClipKey, ClipTrack } from '../../assets/clips/ClipData';
import { clipText } from '../../assets/clips/clipText';
import { GameObject } from '../../core/GameObject';
import { Scene } from '../../core/Scene';
import { Animation } from '../Animation';

export const keys = (...pairs: [number, FieldValue, Partial<ClipKey>?][]): ClipKey[] =>
  pairs.map(([time, value, rest]) => ({ time, value, ...rest }));

export const track = (field: string, list: ClipKey[], path = '', component = 'Transform'): ClipTrack => ({
  path,
  component,
  field,
  keys: list,
});

export const rise = track('position', keys([0, [0, 0, 0]], [1, [0, 1, 0]], [2, [0, 4, 0]]));

export function addClip(scene: Scene, name: string, clip: Partial<ClipData>, duration = 2): void {
  const data = clipText({ tracks: clip.tracks ?? [], events: clip.events ?? [] });
  scene.assets.addFieldAsset('clip', name, { data, duration });
}

export interface Stage {
  scene: Scene;
  object: GameObject;
  animation: Animation;
  errors: string[];
}

export function stage(clip: Partial<ClipData>, values: Record<string, FieldValue> = {}, duration = 2): Stage {
  const scene = new Scene();
  const errors: string[] = [];
  scene.onComponentError = (_component, error) => errors.push((error as Error).message);
  addClip(scene, 'Rise', clip, duration);
  const object = new GameObject('Robot');
  scene.add(object);
  const animation = object.addComponent(Animation, { clip: 'Rise', ...values });
  return { scene, object, animation, errors };
}

export const heightOf = ({ object3D }: GameObject): number => object3D.position.y;
