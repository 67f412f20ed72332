import type { EditorApi } from '../api/EditorApi';
import type { EditorPlugin } from '../api/EditorPlugin';

/** Names of a plugin that something else has. */
function takenNames(editor: EditorApi, plugin: EditorPlugin): string[] {
  const { actions, panels, components, fieldEditors } = editor;
  const { techniques } = editor.viewport.farol;
  return [
    ...(plugin.panels ?? []).filter(({ id }) => panels.get(id)).map(({ id }) => `the panel '${id}'`),
    ...(plugin.actions ?? []).filter(({ id }) => actions.get(id)).map(({ id }) => `the action '${id}'`),
    ...(plugin.components ?? [])
      .filter((type) => components.types.has(type.typeName))
      .map(({ typeName }) => `the component '${typeName}'`),
    ...(plugin.fieldTypes ?? [])
      .filter(({ name }) => fieldEditors.get(name))
      .map(({ name }) => `the type of fields '${name}'`),
    ...Object.keys(plugin.techniques ?? {})
      .filter((name) => Object.hasOwn(techniques, name))
      .map((name) => `the technique '${name}'`),
  ];
}

/**
 * Adds panels, components, kinds of fields, techniques and commands to the editor: all of a plugin, or nothing. They stay
 * until the page is reloaded, since a scene may hold what they brought. Plugins of components should be added before a
 * file that has them is opened.
 *
 * @example
 * addPlugin(editor, { name: 'Notes', panels: [{ id: 'notes', title: 'Notes', icon: 'scene', place: 'right', load }] });
 * @throws Error naming what there is already
 */
export function addPlugin(editor: EditorApi, plugin: EditorPlugin): void {
  const taken = takenNames(editor, plugin);
  if (taken.length > 0) {
    throw new Error(
      `The plugin '${plugin.name}' cannot be added: there is ${taken.join(', ')} already. Choose other names.`,
    );
  }
  for (const { name, editor: control } of plugin.fieldTypes ?? [])
    editor.fieldEditors.add({ id: name, editor: control });
  for (const type of plugin.components ?? []) editor.components.register(type);
  for (const [name, technique] of Object.entries(plugin.techniques ?? {})) {
    editor.viewport.farol.addTechnique(name, technique);
  }
  for (const action of plugin.actions ?? []) editor.actions.add(action);
  for (const panel of plugin.panels ?? []) editor.panels.add(panel);
  plugin.setUp?.(editor);
  editor.viewport.changed.emit();
  editor.document.structure.emit();
  editor.log.add('info', 'plugin', `Added the plugin ${plugin.name}`);
}
