import { persist } from 'zustand/middleware';
import { createStore } from 'zustand';
import type { EditorApi } from '../api/EditorApi';
import { knownPlugins } from '.';

/**
 * Loads the plugins that the user has chosen, and makes a command of each that there is.
 * @param storage - key under which the names of those chosen are kept in the browser
 */
export async function startPlugins(editor: EditorApi, storage = 'farol-editor-plugins'): Promise<void> {
  const store = createStore<{ chosen: readonly string[] }>()(
    persist((): { chosen: readonly string[] } => ({ chosen: [] }), { name: storage }),
  );
  const isChosen = (name: string): boolean => store.getState().chosen.includes(name);
  const loaded = new Set<string>();
  const load = async (name: string): Promise<void> => {
    if (loaded.has(name)) return;
    loaded.add(name);
    editor.addPlugin(await knownPlugins[name].load());
  };
  for (const [name, { label }] of Object.entries(knownPlugins)) {
    editor.actions.add({
      id: `plugins.${name}`,
      label,
      icon: 'object',
      checked: () => isChosen(name),
      async run() {
        const { chosen } = store.getState();
        if (isChosen(name)) {
          store.setState({ chosen: chosen.filter((each) => each !== name) });
          editor.notices.show('info', `${label}: gone once the page is reloaded`, 'plugin');
          return;
        }
        await load(name);
        store.setState({ chosen: [...chosen, name] });
      },
    });
  }
  for (const name of store.getState().chosen) if (Object.hasOwn(knownPlugins, name)) await load(name);
}
