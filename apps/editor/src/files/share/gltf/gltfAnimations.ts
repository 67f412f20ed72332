import { t } from '@farol/editing';
import {
  Animation,
  type ClipAsset,
  type ClipKey,
  type ClipTrack,
  type GameObject,
  type ModelClip,
  type ModelInScene,
  ModelRenderer,
  modelsBelow,
  objectsByName,
  type Scene,
  targetOfTrack,
  trackTarget,
  Transform,
} from '@farol/engine';
import type { EulerField, Vector3Field } from '@farol/engine/fields';
import { AnimationClip, type KeyframeTrack, type Object3D } from 'three';
import { splitName } from '../../../model/assetNames';
import { gltfMorphTracks } from './gltfMorphTracks';
import { gltfTrack } from './gltfTrack';
import type { LeftOut } from './LeftOut';

/** Exported node of each object of the scene, and of each drawn node of a model. */
export type ExportedNodes = ReadonlyMap<GameObject | Object3D, Object3D>;

const properties: Readonly<Record<string, string>> = { position: 'position', rotation: 'quaternion', scale: 'scale' };

/**
 * Clips for GLTFExporter: those played by Animations, and all clips of models that are drawn or unpacked in the scene.
 */
export function gltfAnimations(scene: Scene, nodes: ExportedNodes, leftOut: LeftOut): AnimationClip[] {
  const made: AnimationClip[] = [];
  const done = new Map<ModelClip | ClipAsset, Set<unknown>>();
  const names = new Set<string>();

  const add = (clip: ModelClip | ClipAsset, root: GameObject): void => {
    const isModel = 'isModelClip' in clip;
    const drawn = isModel ? drawnBelow(root, clip) : [];
    const owners = done.get(clip) ?? new Set();
    done.set(clip, owners);
    if (owners.has(drawn[0] ?? root)) return;
    for (const owner of drawn.length > 0 ? drawn : [root]) owners.add(owner);
    const tracks = isModel ? modelTracks(clip, root, nodes, leftOut) : ownTracks(clip, root, nodes, leftOut);
    if (tracks.length === 0) return;
    const baseName = isModel ? clip.name : splitName(clip.name).leaf;
    let name = baseName;
    for (let n = 1; names.has(name); n++)
      name = n === 1 ? `${baseName} (${root.name})` : `${baseName} (${root.name} ${n})`;
    names.add(name);
    made.push(new AnimationClip(name, -1, tracks));
  };

  const { assets } = scene;
  for (const object of nodes.keys()) {
    if (!('components' in object)) continue;
    for (const component of object.components) {
      if (!component.enabled) continue;
      if (component instanceof ModelRenderer) component.drawnModel?.clips.forEach((clip) => add(clip, object));
      if (!(component instanceof Animation) || component.clip === null) continue;
      if (!assets.isReady('clip', component.clip)) continue;
      const clip = assets.clip(component.clip);
      if ('isModelClip' in clip) for (const each of clip.model.clips) add(each, object);
      else add(clip, object);
    }
  }
  for (const each of assets.fieldAssets('clip')) {
    if (!done.has(each as ClipAsset)) leftOut.add(t('Clips that no Animation plays are left out'), each);
  }
  return made;
}

/** Components below an object that draw a clip's model or parts of it. */
const drawnBelow = (root: GameObject, clip: ModelClip): ModelInScene[] =>
  modelsBelow(root, clip.model).filter(({ drawnModel }) => drawnModel === clip.model);

/** The tracks of a model's own clip, made to animate the exported nodes. */
function modelTracks(clip: ModelClip, root: GameObject, nodes: ExportedNodes, leftOut: LeftOut): KeyframeTrack[] {
  const drawn = drawnBelow(root, clip);
  const isWhole = drawn.some(({ partsRoot }) => partsRoot === null);
  const objects = isWhole ? null : objectsByName(root);
  return clip.three.tracks.flatMap((track) => {
    const target = targetOfTrack(clip, track);
    const isMorph = target?.property === 'morphTargetInfluences';
    const sources: (GameObject | Object3D | null | undefined)[] = [];
    if (target && !isMorph) sources.push(objects?.get(target.node.name || target.node.type));
    for (const each of drawn) {
      // the root of a ModelRenderer's parts is not copied: its GameObject stands for that node
      if (target && (isMorph || each.partsRoot !== target.node)) sources.push(each.copyOf(target.node));
    }
    const moved = sources
      .map((source) => source && nodes.get(source))
      .filter((node) => node && (!isMorph || 'morphTargetInfluences' in node));
    if (moved.length === 0) leftOut.add(t('Tracks of clips without a target are left out'), track);
    return moved.map((node) => {
      const copy = track.clone();
      copy.name = `${node!.uuid}.${target!.property}`;
      return copy;
    });
  });
}

/** Extends a track to a time with its last value. */
function longer(track: ClipTrack, time: number): ClipTrack {
  const last = track.keys.at(-1)!;
  const holdingKey: ClipKey = { ...last, easing: track.keys.at(-2)?.easing === 'step' ? 'step' : 'linear' };
  return { ...track, keys: [...track.keys.slice(0, -1), holdingKey, { time, value: last.value }] };
}

function ownTracks(clip: ClipAsset, root: GameObject, nodes: ExportedNodes, leftOut: LeftOut): KeyframeTrack[] {
  const { tracks, events } = clip.clip;
  // in glTF a clip is as long as its longest track
  let isShort = tracks.every(({ keys }) => keys.every(({ time }) => time < clip.duration));
  if (events.length > 0) leftOut.add(t('Events of clips are left out'), clip);
  const morphs = new Map<ModelRenderer, ClipTrack[]>();
  const made = tracks.flatMap((track): KeyframeTrack[] => {
    if (track.keys.length === 0) return [];
    const { component } = trackTarget(root, track);
    const node = component && nodes.get(component.gameObject);
    if (!node) {
      leftOut.add(t('Tracks of clips without a target are left out'), track);
      return [];
    }
    if (component instanceof ModelRenderer && component.fields[track.field].viewOf === 'morphWeights') {
      morphs.set(component, [...(morphs.get(component) ?? []), isShort ? longer(track, clip.duration) : track]);
      isShort = false;
      return [];
    }
    const property = component instanceof Transform && properties[track.field];
    if (!property) {
      leftOut.add(
        t('glTF animates places, turns, sizes and morph weights only: left out are tracks of {component}.{field}', {
          component: track.component,
          field: track.field,
        }),
        track,
      );
      return [];
    }
    const field = component.fields[track.field] as EulerField | Vector3Field;
    const whole = isShort ? longer(track, clip.duration) : track;
    isShort = false;
    const own = gltfTrack(`${node.uuid}.${property}`, whole, field, clip.frameRate);
    if (own.isBaked) leftOut.add(t('Curves and turns that glTF does not have are sampled at the frame rate'), track);
    return [own.track];
  });
  for (const [renderer, list] of morphs) {
    const own = gltfMorphTracks(renderer, list, nodes, clip.frameRate);
    if (own.isBaked) leftOut.add(t('Curves and turns that glTF does not have are sampled at the frame rate'), list);
    made.push(...own.tracks);
  }
  return made;
}
