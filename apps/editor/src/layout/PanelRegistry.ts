import { type ComponentType, lazy } from 'react';
import { Signal } from '../model/Signal';
import type { IconName } from '../ui/iconPaths';
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

/** The panels that there are: the editor's own (`panels/index.ts`), and what plugins add. */
export class PanelRegistry {
  /** Emits when a panel comes or goes. */
  readonly changed = new Signal();

  private panels: readonly Panel[] = [];
  private readonly components = new Map<string, ComponentType>();

  constructor(panels: readonly Panel[]) {
    for (const panel of panels) this.add(panel);
  }

  /** Another array after each change. */
  get list(): readonly Panel[] {
    return this.panels;
  }

  get(id: string): Panel | undefined {
    return this.panels.find((panel) => panel.id === id);
  }

  /** Adds a panel. @returns a function that takes it out. @throws Error when the id is taken */
  add(panel: Panel): () => void {
    if (this.get(panel.id)) throw new Error(`There is a panel '${panel.id}' already: choose another id.`);
    this.panels = [...this.panels, panel];
    this.components.set(
      panel.id,
      lazy(async () => ({ default: await panel.load() })),
    );
    this.changed.emit();
    return () => {
      if (this.get(panel.id) !== panel) return;
      this.panels = this.panels.filter((each) => each !== panel);
      this.components.delete(panel.id);
      this.changed.emit();
    };
  }

  /** The component of a panel, which loads itself; the same for as long as the panel is there. */
  componentOf(id: string): ComponentType | undefined {
    return this.components.get(id);
  }
}
