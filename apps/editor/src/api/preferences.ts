import { persist } from 'zustand/middleware';
import { createStore, type StoreApi } from 'zustand';

/** What the user has set up of the editor itself; kept in the browser, not in files. */
export interface Preferences {
  /** Components that are folded in the inspector, by type. */
  folded: Readonly<Record<string, boolean>>;
  /** 'system' follows the system's light or dark. */
  theme: 'dark' | 'light' | 'system';
  /** By what drags of the handles go while they snap: metres, degrees, part of the size; each above 0. */
  snapSteps: { readonly translate: number; readonly rotate: number; readonly scale: number };
}

export type PreferenceStore = StoreApi<Preferences>;

/** The preferences of one editor. @param storage - key in the browser's storage */
export const createPreferences = (storage: string): PreferenceStore =>
  createStore<Preferences>()(
    persist(
      (): Preferences => ({
        folded: {},
        theme: 'dark',
        snapSteps: { translate: 0.5, rotate: 15, scale: 0.1 },
      }),
      { name: storage },
    ),
  );
