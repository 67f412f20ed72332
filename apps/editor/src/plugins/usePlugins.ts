import { create } from 'zustand';
import { persist } from 'zustand/middleware';
import { actions } from '../actions';
import type { Editor } from '../Editor';
import { knownPlugins } from '.';
import { addPlugin } from './addPlugin';

/** Names of the plugins that the user has chosen; kept in the browser. */
export const usePlugins = create<{ chosen: readonly string[] }>()(
  persist((): { chosen: readonly string[] } => ({ chosen: [] }), { name: 'farol-editor-plugins' }),
);

const choose = (chosen: readonly string[]): void => {
  usePlugins.setState({ chosen });
};

/** Loads the plugins that were chosen, and makes a command of each that there is. */
export async function startPlugins(editor: Editor): Promise<void> {
  const loaded = new Set<string>();
  const load = async (name: string): Promise<void> => {
    if (loaded.has(name)) return;
    loaded.add(name);
    addPlugin(editor, await knownPlugins[name].load());
  };
  for (const [name, { label }] of Object.entries(knownPlugins)) {
    actions.add({
      id: `plugins.${name}`,
      label,
      icon: 'object',
      checked: () => usePlugins.getState().chosen.includes(name),
      async run() {
        const { chosen } = usePlugins.getState();
        if (chosen.includes(name)) {
          choose(chosen.filter((each) => each !== name));
          editor.notices.show('info', `${label}: gone once the page is reloaded`, 'plugin');
          return;
        }
        await load(name);
        choose([...chosen, name]);
      },
    });
  }
  for (const name of usePlugins.getState().chosen) if (Object.hasOwn(knownPlugins, name)) await load(name);
}
