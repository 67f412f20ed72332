import type { Component, ComponentClass } from '@farol/engine';
import { makeUnknownComponent, restoreComponent, serializeObject, UnknownComponent } from '@farol/engine/files';
import type { EditorApi } from '../api/EditorApi';
import type { EditorPlugin } from '../api/EditorPlugin';
import { type ComponentSwap, SwapComponents } from '../model/commands/SwapComponents';
import { Signal, t } from '@farol/editing';
import { installPlugin } from './installPlugin';
import { PluginStep } from './PluginStep';
import { takenNames } from './takenNames';

/** Numbers of components by type, such as '3 Flicker, 1 Beacon'. */
function countsOf(components: readonly Component[]): string {
  const counts = new Map<string, number>();
  for (const { typeName } of components) counts.set(typeName, (counts.get(typeName) ?? 0) + 1);
  return [...counts].map(([type, count]) => `${count} ${type}`).join(', ');
}

/** A component as data, as a file would store it. */
function asUnknown(component: Component): UnknownComponent {
  const { components } = serializeObject(component.gameObject);
  return makeUnknownComponent(components.find(({ id }) => id === component.id)!);
}

/** Adds and removes the plugins of one editor. */
export class Plugins {
  /** Emits when a plugin is added or removed, by undo and redo too. */
  readonly changed = new Signal();

  private readonly installed = new Map<EditorPlugin, () => void>();

  constructor(private readonly editor: EditorApi) {}

  get list(): readonly EditorPlugin[] {
    return [...this.installed.keys()];
  }

  /**
   * Adds everything that a plugin contains, or nothing. Components of the scene that were kept as data, since their
   * class was unknown, become real: a step of history.
   * @throws Error naming what exists already
   */
  add(plugin: EditorPlugin): void {
    const { document, log } = this.editor;
    const taken = takenNames(this.editor, this.list, plugin);
    if (taken.length > 0) {
      throw new Error(
        t("The plugin '{name}' cannot be added: there is {names} already. Choose other names.", {
          name: plugin.name,
          names: taken.join(', '),
        }),
      );
    }
    this.install(plugin);
    const swaps = this.restored(plugin);
    if (swaps.length > 0) {
      const label = t('Brought back {components}', { components: countsOf(swaps.map(({ after }) => after)) });
      const step = new SwapComponents(label, document.scene, swaps);
      document.commands.run(new PluginStep(step, { do: () => this.install(plugin) }));
    }
    log.add('info', 'plugin', t('Added the plugin {name}', { name: plugin.name }));
  }

  /**
   * Removes everything that a plugin added. Its components stay in the scene as data, which are saved: a step of
   * history, and undoing it adds the plugin again. A playing scene is stopped.
   * @throws Error when there is no plugin of that name
   */
  remove(name: string): void {
    const plugin = this.list.find((each) => each.name === name);
    if (!plugin) throw new Error(t("There is no plugin '{name}' to remove.", { name }));
    const { document, notices } = this.editor;
    const { commands } = document;
    document.simulation.stop();
    const components = this.inScene((component) => hasType(plugin, component));
    const isInHistory = commands.history.length > 0 || commands.future.length > 0;
    // a step is also needed when earlier ones contain components of the plugin: undoing those needs the plugin
    if (components.length > 0 || (isInHistory && (plugin.components?.length ?? 0) > 0)) {
      const swaps = components.map((before) => ({ before, after: asUnknown(before) }));
      const step = new SwapComponents(t('Removed plugin {name}', { name }), document.scene, swaps);
      commands.run(new PluginStep(step, { do: () => this.uninstall(plugin), undo: () => this.install(plugin) }));
    } else this.uninstall(plugin);
    const kept =
      components.length === 0
        ? t('The plugin {name} is removed', { name })
        : t('The plugin {name} is removed: {components} kept as data until the plugin is there again', {
            name,
            components: countsOf(components),
          });
    notices.show('info', kept, 'plugin');
  }

  private install(plugin: EditorPlugin): void {
    if (this.installed.has(plugin)) return;
    this.installed.set(plugin, installPlugin(this.editor, plugin));
    this.emit();
  }

  private uninstall(plugin: EditorPlugin): void {
    const withdraw = this.installed.get(plugin);
    if (!withdraw) return;
    this.installed.delete(plugin);
    withdraw();
    this.emit();
  }

  private emit(): void {
    const { viewport, document } = this.editor;
    viewport.changed.emit();
    document.structure.emit();
    this.changed.emit();
  }

  private inScene(isWanted: (component: Component) => boolean): Component[] {
    const found: Component[] = [];
    this.editor.document.scene.traverse(({ components }) => found.push(...components.filter(isWanted)));
    return found;
  }

  /** Swaps of components kept as data for components of the plugin's classes; data that cannot be read are kept. */
  private restored(plugin: EditorPlugin): ComponentSwap[] {
    const { components, notices } = this.editor;
    const types = new Set(plugin.components?.map(({ typeName }) => typeName));
    return this.inScene((each) => each instanceof UnknownComponent && types.has(each.typeName)).flatMap((before) => {
      const { typeName: type, componentClass } = before;
      try {
        const after = restoreComponent(
          { type, version: componentClass.version, values: before.authoredValues() },
          components,
        );
        return { before, after };
      } catch (error) {
        const { name } = before.gameObject;
        notices.show(
          'error',
          t('The {type} of {name} is kept as data: {message}', { type, name, message: (error as Error).message }),
          'plugin',
        );
        return [];
      }
    });
  }
}

const hasType = ({ components }: EditorPlugin, { componentClass }: Component): boolean =>
  components?.includes(componentClass as ComponentClass) ?? false;
