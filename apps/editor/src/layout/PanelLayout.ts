import { persist } from 'zustand/middleware';
import { createStore, type StoreApi } from 'zustand';
import { keptInBrowser } from '../model/keptInBrowser';
import { defaultLayout } from './defaultLayout';
import { activatePanel, growPanel, movePanel, type PanelDrop, removePanel, resizeSplit } from './editLayout';
import { groupsOf, groupWith, type LayoutNode, MAIN_PANEL } from './LayoutNode';
import { openPanel } from './openPanel';
import type { PanelRegistry } from './PanelRegistry';
import { repairLayout } from './repairLayout';

interface LayoutState {
  /** Layout from the browser's storage, maybe of another version; null for the default. See `PanelLayout.current`. */
  stored: LayoutNode | null;
  /** Ids of panels that have existed before; a panel that is not among them is opened. */
  known: readonly string[];
  /** Id of the panel that fills the window; null for none. Not stored. */
  maximised: string | null;
  /** Whether the window is small, with space for only one panel beside the viewport. Not stored. */
  isSmall: boolean;
  /** Id of the panel beside the viewport in a small window; null for none. Not stored. */
  sheet: string | null;
  /** Share of a small window, 0 to 1, that the panel beside the viewport takes. */
  share: number;
  /** Whether the user has resized panels, after which none is grown automatically. */
  isSized: boolean;
}

/** Largest share of the window's height that a panel is grown to automatically. */
const LARGEST_HEIGHT = 0.45;

/** Smallest and largest share of the dock that the panel of a small window takes. */
const LEAST_SHARE = 0.2;
const LARGEST_SHARE = 0.8;

/** Layout of one editor's panels, stored in the browser, with operations by panel id. */
export class PanelLayout {
  private readonly store: StoreApi<LayoutState>;
  private shown: LayoutNode | null = null;
  private shownOf: { stored: LayoutNode | null; revision: number } | null = null;

  /** @param storage - key in localStorage */
  constructor(
    private readonly panels: PanelRegistry,
    storage: string,
  ) {
    this.store = createStore<LayoutState>()(
      persist(
        (): LayoutState => ({
          stored: null,
          known: [],
          maximised: null,
          isSmall: false,
          sheet: null,
          share: 0.5,
          isSized: false,
        }),
        {
          name: storage,
          storage: keptInBrowser(),
          partialize: ({ stored, known, share, isSized }) => ({ stored, known, share, isSized }),
        },
      ),
    );
  }

  /** Calls a listener after each change. @returns a function that stops it */
  readonly subscribe = (listener: () => void): (() => void) => this.store.subscribe(listener);

  /** The layout in use: the stored one, reduced to existing panels. The same object until something changes. */
  readonly current = (): LayoutNode => {
    const { panels } = this;
    const { stored, known } = this.store.getState();
    const { revision } = panels.changed;
    if (this.shown && this.shownOf?.stored === stored && this.shownOf.revision === revision) return this.shown;
    let layout =
      repairLayout(stored, (id) => panels.get(id) !== undefined) ?? defaultLayout(panels.list, innerHeight, innerWidth);
    if (stored) {
      for (const panel of panels.list) {
        const isNew = panel.isOpen !== false && !known.includes(panel.id) && !groupWith(layout, panel.id);
        if (!isNew) continue;
        const front = groupsOf(layout).map(({ active }) => active);
        layout = openPanel(layout, panel, panels.list);
        // the panels that were in front stay in front of new ones
        for (const id of front) layout = activatePanel(layout, id);
      }
    }
    this.shown = layout;
    this.shownOf = { stored, revision };
    return layout;
  };

  readonly maximised = (): string | null => this.store.getState().maximised;

  /** Whether the window has space for only one panel beside the viewport, see `isSmallWindow`. */
  readonly isSmall = (): boolean => this.store.getState().isSmall;

  readonly sheet = (): string | null => this.store.getState().sheet;

  /** Share of a small window that the panel beside the viewport takes, 0 to 1. */
  readonly share = (): number => this.store.getState().share;

  setSmall(isSmall: boolean): void {
    if (isSmall !== this.isSmall()) this.store.setState({ isSmall });
  }

  /** Sets the share of the panel beside the viewport in a small window. */
  shareSheet(share: number): void {
    this.store.setState({ share: Math.min(LARGEST_SHARE, Math.max(LEAST_SHARE, share)) });
  }

  /** Whether a panel is open and not behind another one. */
  isInFront(panel: string): boolean {
    if (this.isSmall()) return panel === MAIN_PANEL || this.sheet() === panel;
    return groupWith(this.current(), panel)?.active === panel;
  }

  isOpen(panel: string): boolean {
    if (this.isSmall()) return this.isInFront(panel);
    return groupWith(this.current(), panel) !== undefined;
  }

  /** Brings a panel to the front, opening it if needed. @throws Error naming the existing panels */
  open(id: string): void {
    const { panels } = this;
    const panel = panels.get(id);
    if (!panel)
      throw new Error(`There is no panel '${id}'. Those there are: ${panels.list.map((each) => each.id).join(', ')}.`);
    const maximised = this.maximised();
    if (maximised !== null && maximised !== id) this.maximise(null);
    if (this.isSmall()) return this.store.setState({ sheet: id === MAIN_PANEL ? null : id });
    const layout = openPanel(this.current(), panel, panels.list);
    const least = this.store.getState().isSized ? 0 : Math.min(panel.height ?? 0, innerHeight * LARGEST_HEIGHT);
    this.set(growPanel(layout, id, Math.round(least)));
  }

  /** Closes a panel; the last one stays. */
  close(panel: string): void {
    if (this.isSmall()) {
      if (this.sheet() === panel) this.store.setState({ sheet: null });
      return;
    }
    const layout = removePanel(this.current(), panel);
    if (!layout) return;
    if (this.maximised() === panel) this.maximise(null);
    this.set(layout);
  }

  move(panel: string, drop: PanelDrop): void {
    this.set(movePanel(this.current(), panel, drop));
  }

  /**
   * Sets the sizes in a split. @param path - indices of children from the root to the split @param sizes - size of each
   * child (CSS pixels)
   */
  resize(path: readonly number[], sizes: readonly number[]): void {
    this.store.setState({ isSized: true });
    this.set(resizeSplit(this.current(), path, sizes));
  }

  /** Makes a panel fill the window; null ends that. */
  maximise(panel: string | null): void {
    this.store.setState({ maximised: panel });
  }

  reset(): void {
    this.store.setState({ stored: null, known: [], maximised: null, isSized: false });
  }

  /** Forgets that a panel existed, so that it is opened when it is added again. */
  forget(panel: string): void {
    const { known, maximised } = this.store.getState();
    if (maximised === panel) this.maximise(null);
    this.store.setState({ known: known.filter((id) => id !== panel) });
  }

  private set(layout: LayoutNode): void {
    const { known } = this.store.getState();
    const ids = this.panels.list.map(({ id }) => id);
    this.store.setState({ stored: layout, known: [...new Set([...known, ...ids])] });
  }
}
