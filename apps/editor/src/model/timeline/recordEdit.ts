import { type Command, currentOf, labelOfField, SetFields, t, tCount } from '@farol/editing';
import type { ClipAsset, ClipData, Component, GameObject } from '@farol/engine';
import type { FieldValue } from '@farol/engine/fields';
import { Sequence } from '../commands/Sequence';
import { clipName, setClip } from './clipEdits';
import { findTrack, type TrackAddress } from './clipTracks';
import { setKey } from './editKeys';
import { addressOf } from './trackTargets';

/** Clip and object that edits are recorded into, as they were when the edit began, and the time of the keys. */
export interface Recording {
  readonly clip: ClipAsset;
  readonly root: GameObject;
  readonly data: ClipData;
  readonly duration: number;
  /** Time of the recorded keys (s). */
  readonly time: number;
}

/** The component that owns a field; null for settings and assets. */
export const componentOf = (owner: unknown): Component | null =>
  (owner as Partial<Component>).isAttached ? (owner as Component) : null;

/** A component's field and its value for a key. */
export interface KeyValue {
  readonly address: TrackAddress;
  readonly value: FieldValue;
  /** Authored value of the field, used for the first key of a new track. */
  readonly authored: FieldValue;
}

/** Sets keys at a time. A new track also gets a key at time 0 with the authored value. */
export function withKeys(data: ClipData, values: readonly KeyValue[], time: number): ClipData {
  let next = data;
  for (const { address, value, authored } of values) {
    if (time > 0 && !findTrack(next, address)) next = setKey(next, address, 0, authored);
    next = setKey(next, address, time, value);
  }
  return next;
}

/**
 * Turns an edit of fields into keys, for components of the animated object and its descendants. Edits of other fields,
 * and other commands, are returned unchanged.
 */
export function recordEdit(command: Command, recording: Recording): Command {
  if (!(command instanceof SetFields)) return command;
  const { clip, root, data, duration, time } = recording;
  const values: KeyValue[] = [];
  const others = command.edits.filter(({ owner, name, value }) => {
    const component = componentOf(currentOf(owner));
    const address = component && addressOf(root, component, name);
    if (address) values.push({ address, value, authored: component.getAuthored(name) });
    return !address;
  });
  if (values.length === 0) return command;
  const next = withKeys(data, values, time);
  const edit = setClip(labelOf(command, values.length, clip), clip, next, duration);
  return others.length === 0 ? edit : Sequence.of(edit.label, [edit, new SetFields(command.label, others)]);
}

function labelOf({ edits }: SetFields, count: number, clip: ClipAsset): string {
  const name = clipName(clip);
  if (count > 1) return tCount(count, 'Recorded {count} key in {name}', 'Recorded {count} keys in {name}', { name });
  const [{ owner, name: field }] = edits;
  return t('Recorded {field} in {name}', { field: labelOfField(field, owner.fields[field]).toLowerCase(), name });
}
