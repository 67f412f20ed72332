import { useStore } from 'zustand';
import type { Action } from '../api/Action';
import type { KeyBindings } from '../api/KeyBindings';
import { useEditor } from './EditorContext';

/** The editor's key bindings; renders the component when they change. */
export function useKeyBindings(): KeyBindings<Action> {
  const { keys } = useEditor();
  useStore(keys.store);
  return keys;
}
