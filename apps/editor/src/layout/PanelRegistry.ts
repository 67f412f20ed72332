import { type ComponentType, lazy } from 'react';
import { Registry } from '../model/Registry';
import type { IconName } from '../style/iconPaths';
import type { PanelPlace } from './defaultLayout';

/** A panel of the editor's window, which the user can move, close and open. */
export interface Panel {
  /** Id of the panel, lower-kebab; stored layouts name it. */
  readonly id: string;
  readonly title: string;
  readonly icon: IconName;
  /** Default place; panels with the same place share a group, in the order of the registry. */
  readonly place: PanelPlace;
  /** Whether the panel is open by default; true when absent. The Panels menu opens others. */
  readonly isOpen?: boolean;
  /**
   * Smallest useful height (CSS pixels): opening the panel at the bottom grows it to that, at most to 45% of the
   * window, unless the user has resized panels. No minimum when absent.
   */
  readonly height?: number;
  /** Fetches the component when the panel is first in front. Its React effects are off while the panel is not. */
  load(): Promise<ComponentType>;
}

/** The panels of one editor: built-in ones (`panels/index.ts`), and those of plugins. */
export class PanelRegistry extends Registry<Panel> {
  private readonly components = new WeakMap<Panel, ComponentType>();

  constructor(panels: readonly Panel[]) {
    super('a panel', panels);
  }

  /** Lazy component of a panel; the same object as long as the panel is registered. */
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
