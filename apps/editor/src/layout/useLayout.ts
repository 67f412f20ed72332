import { create } from 'zustand';
import { persist } from 'zustand/middleware';
import { panels } from '../panels';
import { defaultLayout } from './defaultLayout';
import { activatePanel, movePanel, type PanelDrop, removePanel, resizeSplit } from './editLayout';
import { groupsOf, groupWith, type LayoutNode } from './LayoutNode';
import { openPanel } from './openPanel';
import { repairLayout } from './repairLayout';

interface LayoutState {
  /** What was stored, by this or by another version; null for the layout at first. See `currentLayout`. */
  stored: LayoutNode | null;
  /** Panels that have been there: what is new is opened. */
  known: readonly string[];
  /** The panel that has the whole window; null when all share it. Not stored. */
  maximised: string | null;
}

/** How the panels share the window; kept in the browser. */
export const useLayout = create<LayoutState>()(
  persist((): LayoutState => ({ stored: null, known: [], maximised: null }), {
    name: 'farol-editor-layout',
    partialize: ({ stored, known }) => ({ stored, known }),
  }),
);

let current: LayoutNode | null = null;
let currentOf: { stored: LayoutNode | null; revision: number } | null = null;

/** The layout that is shown: the stored one with the panels that there are now. The same until something changes. */
export function currentLayout(): LayoutNode {
  const { stored, known } = useLayout.getState();
  const { revision } = panels.changed;
  if (current && currentOf?.stored === stored && currentOf.revision === revision) return current;
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
  current = layout;
  currentOf = { stored, revision };
  return layout;
}

function set(layout: LayoutNode): void {
  const { known } = useLayout.getState();
  useLayout.setState({ stored: layout, known: [...new Set([...known, ...panels.list.map(({ id }) => id)])] });
}

/** What can be done to the layout, by id of panel. */
export const layoutActions = {
  isOpen: (panel: string): boolean => groupWith(currentLayout(), panel) !== undefined,

  /** Brings a panel to the front, opened where it is not there. */
  open(id: string): void {
    const panel = panels.get(id);
    if (!panel)
      throw new Error(`There is no panel '${id}'. Those there are: ${panels.list.map((each) => each.id).join(', ')}.`);
    const { maximised } = useLayout.getState();
    if (maximised !== null && maximised !== id) useLayout.setState({ maximised: null });
    set(openPanel(currentLayout(), panel, panels.list));
  },

  /** Takes a panel out of the window; the last one stays. */
  close(panel: string): void {
    const layout = removePanel(currentLayout(), panel);
    if (!layout) return;
    if (useLayout.getState().maximised === panel) useLayout.setState({ maximised: null });
    set(layout);
  },

  move(panel: string, drop: PanelDrop): void {
    set(movePanel(currentLayout(), panel, drop));
  },

  resize(path: readonly number[], sizes: readonly number[]): void {
    set(resizeSplit(currentLayout(), path, sizes));
  },

  /** Gives a panel the whole window, or gives it back. */
  maximise(panel: string | null): void {
    useLayout.setState({ maximised: panel });
  },

  reset(): void {
    useLayout.setState({ stored: null, known: [], maximised: null });
  },
};
