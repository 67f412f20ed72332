import { persist } from 'zustand/middleware';
import { createStore, type StoreApi } from 'zustand';
import { keptInBrowser } from '../model/keptInBrowser';
import type { Language } from '@farol/editing';
import { defaultViews, type ViewChoice } from '../viewport/panes/ViewChoice';
import type { GizmoPivot } from '../viewport/Gizmo';
import type { SnapTarget } from '../viewport/handles/DragSnap';

/** The user's preferences, stored in the browser, not in files. */
export interface Preferences {
  /** Folded components in the inspector, by type. */
  folded: Readonly<Record<string, boolean>>;
  /** Colour theme; 'system' follows the operating system's setting. */
  theme: 'dark' | 'light' | 'system';
  /** Language of the texts; null for the first supported one of the browser's list. */
  language: Language | null;
  /** Snapping increments of the gizmo: m, degrees, share of the size; each above 0. */
  snapSteps: { readonly translate: number; readonly rotate: number; readonly scale: number };
  /** Whether the welcome page is shown when the editor opens. */
  showWelcome: boolean;
  /** Target of snapping, and whether objects dropped on a surface are rotated to its normal. */
  snapTo: SnapTarget;
  alignsToSurface: boolean;
  /** Point that several objects rotate and scale about. */
  pivot: GizmoPivot;
  /** Whether playing scenes are muted. */
  isMuted: boolean;
  /** Number of views (one or four), and their shadings. */
  views: ViewChoice;
}

export type PreferenceStore = StoreApi<Preferences>;

/** The preferences of one editor. @param storage - key in localStorage */
export const createPreferences = (storage: string): PreferenceStore =>
  createStore<Preferences>()(
    persist(
      (): Preferences => ({
        folded: {},
        theme: 'system',
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
