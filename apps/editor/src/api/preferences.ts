import { persist } from 'zustand/middleware';
import { createStore, type StoreApi } from 'zustand';
import { keptInBrowser } from '../model/keptInBrowser';
import type { Language } from '../language/languages';
import { defaultViews, type ViewChoice } from '../viewport/panes/ViewChoice';
import type { GizmoPivot } from '../viewport/Gizmo';
import type { SnapTarget } from '../viewport/handles/DragSnap';

/** What the user has set up of the editor itself; kept in the browser, not in files. */
export interface Preferences {
  /** Components that are folded in the inspector, by type. */
  folded: Readonly<Record<string, boolean>>;
  /** 'system' follows the system's light or dark. */
  theme: 'dark' | 'light' | 'system';
  /** Null for the first of the browser's that there is. */
  language: Language | null;
  /** By what drags of the handles go while they snap: metres, degrees, part of the size; each above 0. */
  snapSteps: { readonly translate: number; readonly rotate: number; readonly scale: number };
  /** Whether the welcome is shown when the editor opens. */
  showWelcome: boolean;
  /** What drags hold to while they snap, and whether what is moved to a surface is turned along it. */
  snapTo: SnapTarget;
  alignsToSurface: boolean;
  /** What several objects turn and grow about. */
  pivot: GizmoPivot;
  /** Whether scenes that play are silent. */
  isMuted: boolean;
  /** One view or four, and how they show the scene. */
  views: ViewChoice;
}

export type PreferenceStore = StoreApi<Preferences>;

/** The preferences of one editor. @param storage - key in the browser's storage */
export const createPreferences = (storage: string): PreferenceStore =>
  createStore<Preferences>()(
    persist(
      (): Preferences => ({
        folded: {},
        theme: 'dark',
        language: null,
        views: defaultViews,
        snapSteps: { translate: 0.5, rotate: 15, scale: 0.1 },
        showWelcome: true,
        snapTo: 'grid',
        alignsToSurface: false,
        pivot: 'centre',
        isMuted: false,
      }),
      { name: storage, storage: keptInBrowser() },
    ),
  );
