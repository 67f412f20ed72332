import { create } from 'zustand';
import { persist } from 'zustand/middleware';

/** What the user has set up of the editor itself; kept in the browser, not in files. */
export interface Preferences {
  /** Components that are folded in the inspector, by type. */
  folded: Readonly<Record<string, boolean>>;
  /** 'system' follows the system's light or dark. */
  theme: 'dark' | 'light' | 'system';
}

export const usePreferences = create<Preferences>()(
  persist((): Preferences => ({ folded: {}, theme: 'dark' }), { name: 'farol-editor' }),
);
