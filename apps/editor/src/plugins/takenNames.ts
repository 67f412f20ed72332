import { t } from '@farol/editing';
import type { EditorApi } from '../api/EditorApi';
import type { EditorPlugin } from '../api/EditorPlugin';

/** Names in a plugin that are taken by the editor, another plugin, or twice in the plugin: "the panel 'notes'". */
export function takenNames(editor: EditorApi, plugins: readonly EditorPlugin[], plugin: EditorPlugin): string[] {
  const { actions, panels, components, fieldEditors, microShaders, viewport } = editor;
  const { techniques } = viewport.farol;
  const names: readonly [noun: string, names: readonly string[], isTaken: (name: string) => boolean][] = [
    [t('the plugin'), [plugin.name], (name) => plugins.some((each) => each.name === name)],
    [t('the panel'), idsOf(plugin.panels), (id) => panels.get(id) !== undefined],
    [t('the action'), idsOf(plugin.actions), (id) => actions.get(id) !== undefined],
    [
      t('the component'),
      (plugin.components ?? []).map(({ typeName }) => typeName),
      (type) => components.types.has(type),
    ],
    [
      t('the type of fields'),
      (plugin.fieldTypes ?? []).map(({ name }) => name),
      (name) => fieldEditors.get(name) !== undefined,
    ],
    [t('the technique'), Object.keys(plugin.techniques ?? {}), (name) => Object.hasOwn(techniques, name)],
    [t('the effect'), Object.keys(plugin.effects ?? {}), (name) => viewport.addedEffects.get(name) !== undefined],
    [t('the microshader'), Object.keys(plugin.microshaders ?? {}), (name) => microShaders.registry.has(name)],
  ];
  return names.flatMap(([noun, all, isTaken]) =>
    all.filter((name, i) => isTaken(name) || all.indexOf(name) < i).map((name) => `${noun} '${name}'`),
  );
}

const idsOf = (items: readonly { readonly id: string }[] = []): string[] => items.map(({ id }) => id);
