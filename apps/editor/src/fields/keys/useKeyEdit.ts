import { useRef, useState } from 'react';
import { insertKey, type KeyPlace, moveKey, removeKey, type TimedKey } from './keyList';

interface KeyEditOptions<K extends TimedKey> {
  /** Keys of the curve or gradient, sorted by time; at least one. */
  readonly keys: readonly K[];
  onPreview(keys: readonly K[]): void;
  /** Commits the keys, or the last preview, as one step of history. */
  onCommit(keys?: readonly K[]): void;
  onAmend(keys: readonly K[]): void;
  onDiscard(): void;
}

/** State of editing a list of keys: the keys, and the selected one. */
export interface KeyEdit<K extends TimedKey> {
  readonly keys: readonly K[];
  /** Index of the selected key. */
  readonly selected: number;
  select(index: number): void;
  /** Adds a key and selects it; a drag may continue with it. */
  add(key: K): void;
  /** Changes the selected key. @param update - gets the key as it was before the edit */
  change(update: (before: K) => K): void;
  /** Changes the selected key. @param update - gets the key as it is now */
  nudge(update: (now: K) => K): void;
  /** Merges a change that arrives late into the last edit. */
  amend(update: (now: K) => K): void;
  /** Removes a key, unless it is the only one. */
  remove(index: number): void;
  /** Ends an edit. @param keeps - whether its result is kept */
  end(keeps: boolean): void;
}

export function useKeyEdit<K extends TimedKey>(options: KeyEditOptions<K>): KeyEdit<K> {
  const { keys, onPreview, onCommit, onAmend, onDiscard } = options;
  const [wanted, setSelected] = useState(0);
  const selected = Math.min(wanted, keys.length - 1);
  /** The keys before the current edit, and the last preview. */
  const edit = useRef<{ before: KeyPlace<K>; shown: KeyPlace<K> } | null>(null);
  const begin = (): { before: KeyPlace<K>; shown: KeyPlace<K> } => {
    const place = { keys, index: selected };
    return (edit.current ??= { before: place, shown: place });
  };
  const show = (shown: KeyPlace<K>, before = begin().before): void => {
    edit.current = { before, shown };
    setSelected(shown.index);
    onPreview(shown.keys);
  };
  const changed = ({ keys: list, index }: KeyPlace<K>, update: (key: K) => K): KeyPlace<K> =>
    moveKey(list, index, update(list[index]));

  return {
    keys,
    selected,
    select: setSelected,
    add(key) {
      const place = insertKey(keys, key);
      show(place, place);
    },
    change: (update) => show(changed(begin().before, update)),
    nudge: (update) => show(changed(begin().shown, update)),
    amend(update) {
      const place = changed({ keys, index: selected }, update);
      setSelected(place.index);
      onAmend(place.keys);
    },
    remove(index) {
      if (keys.length < 2) return;
      edit.current = null;
      setSelected(Math.min(index, keys.length - 2));
      onCommit(removeKey(keys, index));
    },
    end(keeps) {
      if (!edit.current) return;
      const { before } = edit.current;
      edit.current = null;
      if (keeps) return onCommit();
      setSelected(Math.min(before.index, keys.length - 1));
      onDiscard();
    },
  };
}
