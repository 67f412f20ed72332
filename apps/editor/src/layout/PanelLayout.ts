import { persist } from 'zustand/middleware';
import { createStore, type StoreApi } from 'zustand';
import { keptInBrowser } from '../model/keptInBrowser';
import { defaultLayout } from './defaultLayout';
import { activatePanel, movePanel, type PanelDrop, removePanel, resizeSplit } from './editLayout';
import { groupsOf, groupWith, type LayoutNode, MAIN_PANEL } from './LayoutNode';
import { openPanel } from './openPanel';
import type { PanelRegistry } from './PanelRegistry';
import { repairLayout } from './repairLayout';

interface LayoutState {
  /** What was stored, by this or by another version; null for the layout at first. See `PanelLayout.current`. */
  stored: LayoutNode | null;
  /** Panels that have been there: what is new is opened. */
  known: readonly string[];
  /** The panel that has the whole window; null when all share it. Not stored. */
  maximised: string | null;
  /** Whether the window has room for one panel beside the picture only. Not stored. */
  isSmall: boolean;
  /** The panel beside the picture of a small window; null when there is none. Not stored. */
  sheet: string | null;
  /** Part of a small window that this panel takes. */
  share: number;
}

/** Least and largest part of a small window that a panel takes. */
const LEAST_SHARE = 0.2;
const LARGEST_SHARE = 0.8;

/** How the panels of one editor share its window, and what can be done to that, by id of panel; kept in the browser. */
export class PanelLayout {
  private readonly store: StoreApi<LayoutState>;
  private shown: LayoutNode | null = null;
  private shownOf: { stored: LayoutNode | null; revision: number } | null = null;

  /** @param storage - key in the browser's storage */
  constructor(
    private readonly panels: PanelRegistry,
    storage: string,
  ) {
    this.store = createStore<LayoutState>()(
      persist(
        (): LayoutState => ({ stored: null, known: [], maximised: null, isSmall: false, sheet: null, share: 0.5 }),
        {
          name: storage,
          storage: keptInBrowser(),
          partialize: ({ stored, known, share }) => ({ stored, known, share }),
        },
      ),
    );
  }

  /** Calls a listener after each change. @returns a function that ends it */
  readonly subscribe = (listener: () => void): (() => void) => this.store.subscribe(listener);

  /** The layout that is shown: the stored one with the panels that there are now. The same until something changes. */
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
        // it comes behind what is in front
        for (const id of front) layout = activatePanel(layout, id);
      }
    }
    this.shown = layout;
    this.shownOf = { stored, revision };
    return layout;
  };

  /** The panel that has the whole window; null when all share it. */
  readonly maximised = (): string | null => this.store.getState().maximised;

  /** Whether the window has room for one panel beside the picture only: see `isSmallWindow`. */
  readonly isSmall = (): boolean => this.store.getState().isSmall;

  /** The panel beside the picture of a small window; null when there is none. */
  readonly sheet = (): string | null => this.store.getState().sheet;

  /** Part of a small window that the panel beside the picture takes, from 0 to 1. */
  readonly share = (): number => this.store.getState().share;

  /** Says whether the window is small. */
  setSmall(isSmall: boolean): void {
    if (isSmall !== this.isSmall()) this.store.setState({ isSmall });
  }

  /** Gives the panel beside the picture of a small window its part. */
  shareSheet(share: number): void {
    this.store.setState({ share: Math.min(LARGEST_SHARE, Math.max(LEAST_SHARE, share)) });
  }

  /** Whether a panel is there and no other one lies over it. */
  isInFront(panel: string): boolean {
    if (this.isSmall()) return panel === MAIN_PANEL || this.sheet() === panel;
    return groupWith(this.current(), panel)?.active === panel;
  }

  isOpen(panel: string): boolean {
    if (this.isSmall()) return this.isInFront(panel);
    return groupWith(this.current(), panel) !== undefined;
  }

  /** Brings a panel to the front, opened where it is not there. @throws Error naming the panels that there are */
  open(id: string): void {
    const { panels } = this;
    const panel = panels.get(id);
    if (!panel)
      throw new Error(`There is no panel '${id}'. Those there are: ${panels.list.map((each) => each.id).join(', ')}.`);
    const maximised = this.maximised();
    if (maximised !== null && maximised !== id) this.maximise(null);
    if (this.isSmall()) return this.store.setState({ sheet: id === MAIN_PANEL ? null : id });
    this.set(openPanel(this.current(), panel, panels.list));
  }

  /** Takes a panel out of the window; the last one stays. */
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

  /** @param path - indices of children from the root to the split @param sizes - one of each child (CSS pixels) */
  resize(path: readonly number[], sizes: readonly number[]): void {
    this.set(resizeSplit(this.current(), path, sizes));
  }

  /** Gives a panel the whole window; null gives it back. */
  maximise(panel: string | null): void {
    this.store.setState({ maximised: panel });
  }

  /** Panels are where they were at first. */
  reset(): void {
    this.store.setState({ stored: null, known: [], maximised: null });
  }

  /** Treats a panel as one that has never been there: it opens when it comes again. */
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
