import { shortText } from '@farol/editing';
import { type Interpolant, type KeyframeTrack, type Object3D, PropertyBinding } from 'three';
import type { ClipAsset } from '../assets/clips/ClipAsset';
import type { ModelClip } from '../assets/Model';
import type { GameObject } from '../core/GameObject';
import type { Channel, NodeProperty } from './Channel';
import type { ClipEvent } from '../assets/clips/ClipData';
import type { ModelInScene } from './modelsBelow';
import { type TrackCurve, curveOf } from './TrackCurve';
import { trackTarget } from './trackTarget';

/** One track of a clip, bound to its channel. */
export interface Binding {
  readonly channel: Channel;
  /** Curve of a track of a clip asset; null for a clip of a model. */
  readonly curve: TrackCurve | null;
  /** three's interpolant of a track of a model's clip; null for a clip asset. */
  readonly interpolant: Interpolant | null;
  readonly isQuaternion: boolean;
  /** Index of the key that the last sampling found, where the next search begins. */
  index: number;
}

export interface BoundClip {
  readonly duration: number;
  readonly events: readonly ClipEvent[];
  readonly bindings: readonly Binding[];
  /** Messages on tracks that cannot be played, each with its remedy. */
  readonly problems: readonly string[];
}

/** Source of channels for fields and nodes. */
export interface ChannelSource {
  fieldChannel(component: GameObject['transform'], field: string): Channel;
  nodeChannel(node: Object3D, property: NodeProperty): Channel;
}

/** Binds the tracks of a clip asset. @param root - root of the tracks' paths @throws ClipError */
export function bindOwnClip(asset: ClipAsset, root: GameObject, channels: ChannelSource): BoundClip {
  const { tracks, events } = asset.clip;
  const bindings: Binding[] = [];
  const problems: string[] = [];
  for (const track of tracks) {
    if (track.keys.length === 0) continue;
    const { component, problem } = trackTarget(root, track);
    if (!component) {
      problems.push(problem);
      continue;
    }
    bindings.push({
      channel: channels.fieldChannel(component as GameObject['transform'], track.field),
      curve: curveOf(track, component.fields[track.field]),
      interpolant: null,
      isQuaternion: false,
      index: 0,
    });
  }
  return { duration: asset.duration, events, bindings, problems };
}

const nodeProperties: Readonly<Record<string, NodeProperty>> = {
  position: 'position',
  quaternion: 'quaternion',
  scale: 'scale',
  morphTargetInfluences: 'morphTargetInfluences',
};

/** Track name of a model's clip: the node's name, or the uuid of a nameless node. */
interface TrackName {
  readonly nodeName?: string;
  readonly propertyName: string;
  readonly propertyIndex?: string;
  readonly objectName?: string;
}

/** Node that a track of a model's clip moves, in the loaded model (not in its copies in scenes). */
const nodeOfTrack = (clip: ModelClip, { nodeName = '' }: TrackName): Object3D | null =>
  PropertyBinding.findNode(clip.model.scene, nodeName) as Object3D | null;

/** The track's node and property in the model; null where the engine does not animate them. */
export function targetOfTrack(
  clip: ModelClip,
  track: KeyframeTrack,
): { readonly node: Object3D; readonly property: NodeProperty } | null {
  let name: TrackName;
  try {
    name = PropertyBinding.parseTrackName(track.name) as unknown as TrackName;
  } catch {
    return null;
  }
  const property = Object.hasOwn(nodeProperties, name.propertyName) ? nodeProperties[name.propertyName] : null;
  const node = nodeOfTrack(clip, name);
  return node && property && !name.objectName && name.propertyIndex === undefined ? { node, property } : null;
}

/**
 * Channels for a property of a model's node: on each drawn copy of the node, and on the object of the node's name where
 * the model is unpacked; else a message with its remedy.
 */
function channelsOfNode(
  { node, property }: { readonly node: Object3D; readonly property: NodeProperty },
  clip: ModelClip,
  root: GameObject,
  objects: ReadonlyMap<string, GameObject>,
  drawn: readonly ModelInScene[],
  channels: ChannelSource,
): Channel[] | string {
  const name = node.name || node.type;
  const isMorph = property === 'morphTargetInfluences';
  const isWhole = drawn.some((each) => each.drawnModel === clip.model && each.partsRoot === null);
  const object = isWhole ? undefined : objects.get(name);
  const found: Channel[] = [];
  if (object && !isMorph)
    found.push(channels.fieldChannel(object.transform, property === 'quaternion' ? 'rotation' : property));
  for (const each of drawn) {
    const { three } = each;
    const isOwn = each.drawnModel === clip.model;
    // skips roots of drawn parts, which their object poses, and other models, if an object has the node's name
    if (!isMorph && (isOwn ? each.partsRoot === node : object)) continue;
    const copy = isOwn ? each.copyOf(node) : three && (PropertyBinding.findNode(three, name) as Object3D | null);
    if (copy && (!isMorph || 'morphTargetInfluences' in copy)) found.push(channels.nodeChannel(copy, property));
  }
  if (found.length > 0) return found;
  const where = `'${shortText(root.name)}/${shortText(name)}'`;
  return object || drawn.some((each) => each.copyOf(node))
    ? `${where} has no morph targets: show its model by a ModelRenderer.`
    : `the object ${where} is gone: give an object below this name, or choose another clip.`;
}

/**
 * Binds the tracks of a model's clip: to nodes of the model if it is drawn whole, else to objects of the same names and
 * to drawn parts, or to nodes of the same names in another model.
 * @param drawn - renderers of the clip's model, or of any model, below the object: see `modelsBelow`
 */
export function bindModelClip(
  clip: ModelClip,
  root: GameObject,
  drawn: readonly ModelInScene[],
  channels: ChannelSource,
): BoundClip {
  const bindings: Binding[] = [];
  const problems = new Set<string>();
  const objects = objectsByName(root);
  for (const track of clip.three.tracks) {
    const target = targetOfTrack(clip, track);
    const moved = target
      ? channelsOfNode(target, clip, root, objects, drawn, channels)
      : `its track '${shortText(track.name, 80)}' animates something that Farol cannot animate: it is left out.`;
    if (typeof moved === 'string') problems.add(moved);
    else {
      const isQuaternion = target?.property === 'quaternion';
      for (const channel of moved)
        bindings.push({ channel, curve: null, interpolant: interpolantOf(track), isQuaternion, index: 0 });
    }
  }
  return { duration: clip.duration, events: [], bindings, problems: [...problems] };
}

/** three's interpolant (linear, steps, or a glTF's cubic splines), writing double precision, as three's mixer does. */
function interpolantOf(track: KeyframeTrack): Interpolant {
  const { createInterpolant } = track as unknown as { createInterpolant(): Interpolant };
  const interpolant = createInterpolant.call(track);
  (interpolant as { resultBuffer: unknown }).resultBuffer = new Float64Array(interpolant.resultBuffer.length);
  return interpolant;
}

/** An object and its descendants by name; the first one for each name. */
export function objectsByName(root: GameObject): Map<string, GameObject> {
  const objects = new Map<string, GameObject>();
  root.traverse((each) => {
    if (!objects.has(each.name)) objects.set(each.name, each);
  });
  return objects;
}
