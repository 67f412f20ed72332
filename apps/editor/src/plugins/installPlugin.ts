import { t } from '@farol/editing';
import type { EditorApi } from '../api/EditorApi';
import type { EditorPlugin } from '../api/EditorPlugin';

/** Adds all parts of a plugin, whose names must be free. @returns a function that removes them */
export function installPlugin(editor: EditorApi, plugin: EditorPlugin): () => void {
  const { actions, panels, layout, components, fieldEditors, microShaders, viewport, notices } = editor;
  const { farol } = viewport;
  /** Functions that remove each part, called in reverse order. */
  const endings: (() => void)[] = [];
  if (plugin.microshaders) {
    const takeOut = microShaders.addChunks(plugin.microshaders);
    endings.push(() => {
      const kept = takeOut();
      if (kept.length === 0) return;
      notices.show(
        'warning',
        t('Microshaders of {name} stay, since others need them: {names}', {
          name: plugin.name,
          names: kept.join(', '),
        }),
        'plugin',
      );
    });
  }
  for (const type of plugin.components ?? []) {
    components.register(type);
    endings.push(() => components.unregister(type));
  }
  for (const { name, editor: control } of plugin.fieldTypes ?? [])
    endings.push(fieldEditors.add({ id: name, editor: control }));
  for (const [name, technique] of Object.entries(plugin.techniques ?? {})) {
    farol.addTechnique(name, technique);
    viewport.picture.retakeTechnique();
    endings.push(() => {
      // the painter is removed first: its renderers for comparing techniques may use this technique
      viewport.painter = null;
      farol.removeTechnique(name);
    });
  }
  for (const [id, effect] of Object.entries(plugin.effects ?? {}))
    endings.push(viewport.addedEffects.add({ id, label: effect.label, help: effect.help, make: () => effect.make() }));
  for (const action of plugin.actions ?? []) endings.push(actions.add(action));
  for (const panel of plugin.panels ?? []) {
    const takeOut = panels.add(panel);
    endings.push(() => {
      // the layout forgets an open panel, so that it opens again when the plugin is added again
      if (layout.isOpen(panel.id)) layout.forget(panel.id);
      takeOut();
    });
  }
  const end = plugin.setUp?.(editor);
  if (end) endings.push(end);
  return () => {
    for (const ending of endings.toReversed()) ending();
  };
}
