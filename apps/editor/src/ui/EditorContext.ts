import type { Signal } from '@farol/editing';
import { createContext, useContext, useSyncExternalStore } from 'react';
import type { EditorApi } from '../api/EditorApi';

const Context = createContext<EditorApi | null>(null);

/** Gives the editor to all components below. */
export const EditorProvider = Context.Provider;

/** The editor. */
export function useEditor(): EditorApi {
  const editor = useContext(Context);
  if (!editor) throw new Error('No editor: render the component below EditorProvider.');
  return editor;
}

/** Renders again after each change of a signal. @returns its revision */
export function useSignal(signal: Signal): number {
  return useSyncExternalStore(signal.subscribe, () => signal.revision);
}
