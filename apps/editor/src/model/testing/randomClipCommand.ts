import type { Command } from '@farol/editing';
import type { ClipAsset, GameObject } from '@farol/engine';
import { deleteAsset } from '../assetUsages';
import type { EditorDocument } from '../EditorDocument';
import { clipDataOf } from '../timeline/clipDataOf';
import { addClip, setClip, setDuration } from '../timeline/clipEdits';
import { clipPlayer } from '../timeline/clipPlayer';
import { keyId, trackId } from '../timeline/clipTracks';
import { copyKeys, pasteKeys } from '../timeline/copyKeys';
import { addEvent, removeEvents } from '../timeline/editEvents';
import { deleteKeys, easeKeys, moveKeys, scaleKeys, setKey } from '../timeline/editKeys';
import { recordEdit } from '../timeline/recordEdit';
import { below, pick, type Random } from './random';
import { randomEdit } from './randomEdit';

/** A random edit of the library's clips: adds one, edits keys, events or length, records an edit, or removes one. */
export function randomClipCommand(random: Random, document: EditorDocument, object: GameObject): Command {
  const { scene, assets } = document;
  const clips = assets.fieldAssets('clip') as ClipAsset[];
  const act = below(random, 10);
  if (clips.length < 1 || (act === 0 && clips.length < 4))
    return addClip(scene, `Clip ${below(random, 20)}`, random() < 0.7 ? object : null, clipPlayer(scene)).command;
  const clip = pick(random, clips);
  if (act === 1 && clips.length > 2) return deleteAsset(scene, clip.name);
  if (act === 2) return setDuration(clip, random() * 4);
  const data = clipDataOf(clip);
  const selected = new Set(
    data.tracks.flatMap((track) =>
      track.keys.filter(() => random() < 0.5).map(({ time }) => keyId(trackId(track), time)),
    ),
  );
  const time = below(random, 90) / 30;
  if (act === 3 && selected.size > 0) return setClip('Move', clip, moveKeys(data, selected, random() * 2 - 1).data);
  if (act === 4 && selected.size > 0) return setClip('Scale', clip, scaleKeys(data, selected, time, random() * 2).data);
  if (act === 5 && selected.size > 0) return setClip('Delete', clip, deleteKeys(data, selected));
  if (act === 6 && selected.size > 0) {
    const eased = easeKeys(data, selected, 'bezier', [random(), random() * 3 - 1, random(), random()]);
    return setClip('Ease', clip, pasteKeys(eased, copyKeys(eased, selected)!, time).data);
  }
  if (act === 7) {
    const events = addEvent(data, { time, method: 'onEvent', value: below(random, 3) }).data;
    return setClip('Event', clip, events.events.length > 3 ? removeEvents(events, [1]) : events);
  }
  const position = { path: 'Arm', component: 'Transform', field: 'position' };
  if (act === 8) return setClip('Key', clip, setKey(data, position, time, [random(), random(), random()]));
  // components of scripts that do not run have no fields
  const owners = object.components.filter(({ fields }) => Object.keys(fields).length > 0);
  const edit = randomEdit(random, document, pick(random, owners));
  return recordEdit(edit, { clip, root: object, data, duration: clip.duration, time });
}
