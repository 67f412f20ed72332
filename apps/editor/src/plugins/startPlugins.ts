import { createStore } from 'zustand';
import { persist } from 'zustand/middleware';
import type { EditorApi } from '../api/EditorApi';
import type { EditorPlugin } from '../api/EditorPlugin';
import { knownPlugins } from '.';

/**
 * Loads the plugins that the user has switched on, and adds an action for each known plugin, which switches it.
 * @param storage - key in localStorage with the names of the plugins that are on
 */
export async function startPlugins(editor: EditorApi, storage = 'farol-editor-plugins'): Promise<void> {
  const store = createStore<{ chosen: readonly string[] }>()(
    persist((): { chosen: readonly string[] } => ({ chosen: [] }), { name: storage }),
  );
  const loaded = new Map<string, EditorPlugin>();
  const added = (name: string): EditorPlugin | undefined =>
    editor.plugins.list.find((plugin) => plugin === loaded.get(name));
  const add = async (name: string): Promise<void> => {
    const plugin = loaded.get(name) ?? (await knownPlugins[name].load());
    loaded.set(name, plugin);
    editor.addPlugin(plugin);
  };
  for (const [name, { label }] of Object.entries(knownPlugins)) {
    editor.actions.add({
      id: `plugins.${name}`,
      label,
      icon: 'object',
      checked: () => added(name) !== undefined,
      async run() {
        const plugin = added(name);
        if (plugin) editor.removePlugin(plugin.name);
        else await add(name);
      },
    });
  }
  const { chosen } = store.getState();
  for (const name of chosen) if (Object.hasOwn(knownPlugins, name)) await add(name);
  // undo and redo add and remove plugins too
  editor.plugins.changed.subscribe(() => {
    store.setState({ chosen: Object.keys(knownPlugins).filter((name) => added(name) !== undefined) });
  });
}
