import { useStore } from 'zustand';
import type { Preferences } from '../api/preferences';
import { useEditor } from './EditorContext';

/** A part of the editor's preferences; renders the component when that part changes. */
export const usePreferences = <T>(select: (preferences: Preferences) => T): T =>
  useStore(useEditor().preferences, select);
