import type { Signal } from '@farol/editing';
import { createContext, useContext, useSyncExternalStore } from 'react';
import type { EditorApi } from '../api/EditorApi';

const Context = createContext<EditorApi | null>(null);

/** Provides the editor to the components below. */
export const EditorProvider = Context.Provider;

/** The editor of the page. @throws Error outside of an EditorProvider */
export function useEditor(): EditorApi {
  const editor = useContext(Context);
  if (!editor) throw new Error('No editor: render the component below EditorProvider.');
  return editor;
}

/** Renders the component each time a signal emits. @returns the signal's revision */
export function useSignal(signal: Signal): number {
  return useSyncExternalStore(signal.subscribe, () => signal.revision);
}
