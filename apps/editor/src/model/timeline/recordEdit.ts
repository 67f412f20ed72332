import { type Command, labelOfField, SetFields, t, tCount } from '@farol/editing';
import type { ClipAsset, ClipData, Component, GameObject } from '@farol/engine';
import type { FieldValue } from '@farol/engine/fields';
import { CommandList } from '../commands/CommandList';
import { clipName, setClip } from './clipEdits';
import { findTrack, type TrackAddress } from './clipTracks';
import { setKey } from './editKeys';
import { addressOf } from './trackTargets';

/** What is recorded: a clip of an object, as it was when the edit began, and the time of the keys. */
export interface Recording {
  readonly clip: ClipAsset;
  readonly root: GameObject;
  readonly data: ClipData;
  readonly duration: number;
  /** Seconds from the beginning of the clip. */
  readonly time: number;
}

/** The component that a field is of; null for settings and assets. */
export const componentOf = (owner: unknown): Component | null =>
  (owner as Partial<Component>).isAttached ? (owner as Component) : null;

/** A value of a field of a component, for a key. */
export interface KeyValue {
  readonly address: TrackAddress;
  readonly value: FieldValue;
  /** What the field has without the clip: a new track begins with it. */
  readonly authored: FieldValue;
}

/** Sets keys at a time. A new track gets a key at the beginning too, with what was authored. */
export function withKeys(data: ClipData, values: readonly KeyValue[], time: number): ClipData {
  let next = data;
  for (const { address, value, authored } of values) {
    if (time > 0 && !findTrack(next, address)) next = setKey(next, address, 0, authored);
    next = setKey(next, address, time, value);
  }
  return next;
}

/**
 * The command that makes keys of an edit of fields: those of components of the animated object and of all below it. Other
 * fields are edited as asked. Commands that are no edits of fields are given back as they are.
 */
export function recordEdit(command: Command, recording: Recording): Command {
  if (!(command instanceof SetFields)) return command;
  const { clip, root, data, duration, time } = recording;
  const values: KeyValue[] = [];
  const others = command.edits.filter(({ owner, name, value }) => {
    const component = componentOf(owner);
    const address = component && addressOf(root, component, name);
    if (address) values.push({ address, value, authored: component.getAuthored(name) });
    return !address;
  });
  if (values.length === 0) return command;
  const next = withKeys(data, values, time);
  const edit = setClip(labelOf(command, values.length, clip), clip, next, duration);
  return others.length === 0 ? edit : new CommandList(edit.label, [edit, new SetFields(command.label, others)]);
}

function labelOf({ edits }: SetFields, count: number, clip: ClipAsset): string {
  const name = clipName(clip);
  if (count > 1) return tCount(count, 'Recorded {count} key in {name}', 'Recorded {count} keys in {name}', { name });
  const [{ owner, name: field }] = edits;
  return t('Recorded {field} in {name}', { field: labelOfField(field, owner.fields[field]).toLowerCase(), name });
}
