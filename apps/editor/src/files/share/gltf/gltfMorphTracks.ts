import { type ClipTrack, type ModelRenderer, morphField, valueAt } from '@farol/engine';
import { type KeyframeTrack, Mesh, NumberKeyframeTrack, type Object3D } from 'three';
import { beforeTime } from './beforeTime';

/** Key times (s) for linear interpolation of tracks, and whether curves were sampled. */
function timesOf(tracks: readonly ClipTrack[], frameRate: number): { times: number[]; isBaked: boolean } {
  const times = new Set<number>();
  let isBaked = false;
  for (const { keys } of tracks) {
    keys.forEach(({ time, easing }, i) => {
      times.add(Math.fround(time));
      const next = keys[i + 1]?.time;
      if (next === undefined) return;
      if (easing === 'step') times.add(beforeTime(next));
      else if (easing === 'bezier') {
        isBaked = true;
        for (let frame = Math.floor(time * frameRate) + 1; frame / frameRate < next; frame++)
          times.add(Math.fround(frame / frameRate));
      }
    });
  }
  return { times: [...times].toSorted((a, b) => a - b), isBaked };
}

/**
 * Converts tracks of morph target weights to glTF: one per mesh with the weights of all its targets, linearly
 * interpolated. A weight without a track is constant.
 * @param tracks - tracks of one ModelRenderer's morph targets, with keys
 * @param nodes - exported node of each mesh
 * @param frameRate - sampling rate of curves (Hz)
 */
export function gltfMorphTracks(
  renderer: ModelRenderer,
  tracks: readonly ClipTrack[],
  nodes: ReadonlyMap<unknown, Object3D>,
  frameRate: number,
): { readonly tracks: KeyframeTrack[]; readonly isBaked: boolean } {
  const { times, isBaked } = timesOf(tracks, frameRate);
  const made: KeyframeTrack[] = [];
  renderer.three?.traverse((mesh) => {
    const node = nodes.get(mesh);
    if (!(mesh instanceof Mesh && mesh.morphTargetDictionary && node)) return;
    const animated = Object.entries(mesh.morphTargetDictionary).flatMap(([name, index]) => {
      const track = tracks.find(({ field }) => field === morphField(name));
      return track ? [{ track, index, field: renderer.fields[track.field] }] : [];
    });
    if (animated.length === 0) return;
    const values = times.flatMap((time) => {
      const weights = [...mesh.morphTargetInfluences!];
      for (const { track, index, field } of animated) weights[index] = valueAt(track, field, time) as number;
      return weights;
    });
    made.push(new NumberKeyframeTrack(`${node.uuid}.morphTargetInfluences`, times, values));
  });
  return { tracks: made, isBaked };
}
