import type { EditorPlugin } from '../api/EditorPlugin';

/** Plugins that come with the editor, fetched when the user adds them. A new plugin takes a folder and a line here. */
export const knownPlugins: Readonly<Record<string, { label: string; load(): Promise<EditorPlugin> }>> = {
  lantern: {
    label: 'Lantern: an example of a plugin',
    load: () => import('./lantern').then(({ lantern }) => lantern),
  },
};
