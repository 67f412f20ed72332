import { type ComponentType, lazy } from 'react';
import { Registry } from '../model/Registry';
import type { IconName } from '../style/iconPaths';
import type { PanelPlace } from './defaultLayout';

/** A part of the editor's window, which the user can move, close and open. */
export interface Panel {
  /** Lower-kebab; layouts are stored with it. */
  readonly id: string;
  /** What its tab says. */
  readonly title: string;
  readonly icon: IconName;
  /** Where it is at first; panels of one place share a group of tabs, in the order of the registry. */
  readonly place: PanelPlace;
  /** Whether it is there at first; true when absent. The Panels menu opens what is not. */
  readonly isOpen?: boolean;
  /** Loads the component when the panel is first in front. While it is behind another, its effects are off. */
  load(): Promise<ComponentType>;
}

/** The panels of one editor: its own (`panels/index.ts`), and those of plugins. */
export class PanelRegistry extends Registry<Panel> {
  private readonly components = new WeakMap<Panel, ComponentType>();

  constructor(panels: readonly Panel[]) {
    super('a panel', panels);
  }

  /** The component of a panel, which loads itself when first rendered; the same for as long as the panel is there. */
  componentOf(id: string): ComponentType | undefined {
    const panel = this.get(id);
    if (!panel) return undefined;
    let component = this.components.get(panel);
    if (!component) {
      component = lazy(async () => ({ default: await panel.load() }));
      this.components.set(panel, component);
    }
    return component;
  }
}
