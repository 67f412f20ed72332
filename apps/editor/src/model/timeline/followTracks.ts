import { type Command, SetFields } from '@farol/editing';
import {
  type ClipAsset,
  type ClipData,
  type ClipTrack,
  type GameObject,
  objectAtPath,
  pathBelow,
  type Scene,
} from '@farol/engine';
import { Sequence } from '../commands/Sequence';
import { clipDataOf, noteClipData, trackId, writeClip } from './clipDataOf';
import { playedClip } from './clipPlayer';

/** An object that a path of a clip leads to, below one of the objects that play the clip. */
interface Found {
  readonly root: GameObject;
  readonly object: GameObject;
}

/** Objects that tracks animate: by clip, then by path. The root has no path, and is left out. */
type TrackObjects = ReadonlyMap<ClipAsset, ReadonlyMap<string, readonly Found[]>>;

/** Objects that the tracks of all played clips animate. */
function trackObjects(scene: Scene): TrackObjects {
  const clips = new Map<ClipAsset, Map<string, Found[]>>();
  for (const { gameObject: root } of scene.componentsOf('Animation')) {
    const name = playedClip(root);
    const clip = name === null ? null : scene.assets.fieldAsset(name);
    if (clip?.type !== 'clip') continue;
    const byPath = clips.get(clip as ClipAsset) ?? new Map<string, Found[]>();
    clips.set(clip as ClipAsset, byPath);
    for (const path of new Set(clipDataOf(clip as ClipAsset).tracks.map((track) => track.path))) {
      const object = path === '' ? null : objectAtPath(root, path);
      if (object) byPath.set(path, [...(byPath.get(path) ?? []), { root, object }]);
    }
  }
  return clips;
}

/** The new path that leads to several objects, each below its own root; null when their paths differ. */
function commonPath(found: readonly Found[]): string | null {
  const paths = new Set(found.map(({ root, object }) => pathBelow(root, object)));
  return paths.size === 1 ? [...paths][0] : null;
}

function setTracks(label: string, clip: ClipAsset, data: ClipData): Command {
  const value = writeClip(data);
  noteClipData(clip, value, data);
  return new SetFields(label, [{ owner: clip, name: 'data', value }]);
}

/** Edits of tracks after which they animate the same objects as before. */
function edits(label: string, before: TrackObjects): Command[] {
  const commands: Command[] = [];
  for (const [clip, byPath] of before) {
    const moved = new Map<string, string>();
    for (const [path, found] of byPath) {
      const next = commonPath(found);
      if (next !== null && next !== path) moved.set(path, next);
    }
    if (moved.size === 0) continue;
    const data = clipDataOf(clip);
    const staying = new Set(data.tracks.filter(({ path }) => !moved.has(path)).map(trackId));
    const tracks = data.tracks.map((track): ClipTrack => {
      const next = { ...track, path: moved.get(track.path) ?? track.path };
      return next.path === track.path || staying.has(trackId(next)) ? track : next;
    });
    if (tracks.some((track, i) => track !== data.tracks[i])) commands.push(setTracks(label, clip, { ...data, tracks }));
  }
  return commands;
}

/** Renames a component type in the tracks of all clips. */
export function retypeTracks(label: string, { assets }: Scene, from: string, to: string): Command[] {
  return (assets.fieldAssets('clip') as ClipAsset[]).flatMap((clip) => {
    const data = clipDataOf(clip);
    if (!data.tracks.some(({ component }) => component === from)) return [];
    const tracks = data.tracks.map((track) => (track.component === from ? { ...track, component: to } : track));
    return [setTracks(label, clip, { ...data, tracks })];
  });
}

/**
 * Wraps a command that renames or moves objects, so that, in the same step, tracks of the scene's clips are changed to
 * animate the same objects afterwards. A track is unchanged when no path can do so: the object is no longer below the
 * one that plays the clip, or another player of the clip would lose its object.
 */
export function followTracks(scene: Scene, command: Command): Command {
  if (command.isEmpty || scene.componentsOf('Animation').length === 0) return command;
  const { label } = command;
  let before: TrackObjects = new Map();
  return new Sequence(
    label,
    [
      () => {
        before = trackObjects(scene);
        return command;
      },
      () => Sequence.of(label, edits(label, before)),
    ],
    command.selection,
  );
}
