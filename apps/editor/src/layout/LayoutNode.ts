/** Panels that share a place, one of them in front. */
export interface PanelGroup {
  readonly kind: 'group';
  /** Its own within a layout. */
  readonly id: string;
  /** Ids of panels, in the order of their tabs; at least one. */
  readonly panels: readonly string[];
  /** The one in front. */
  readonly active: string;
}

/** Places side by side ('row'), or one above the other ('column'). */
export interface LayoutSplit {
  readonly kind: 'split';
  readonly direction: 'row' | 'column';
  /** At least two, none of them a split of the same direction. */
  readonly children: readonly LayoutNode[];
  /**
   * Width or height that each child would like (CSS pixels). The child with the viewport takes what is left over, however
   * large the window is.
   */
  readonly sizes: readonly number[];
}

/** How the panels share the window. */
export type LayoutNode = PanelGroup | LayoutSplit;

/** Where in a group a panel is put: into it, or beside it. */
export type DropSide = 'centre' | 'left' | 'right' | 'top' | 'bottom';

/** The panel that takes what the others leave. */
export const MAIN_PANEL = 'viewport';

/** All groups, from left to right and from top to bottom. */
export function groupsOf(node: LayoutNode): PanelGroup[] {
  return node.kind === 'group' ? [node] : node.children.flatMap(groupsOf);
}

/** The group that a panel is in. */
export const groupWith = (node: LayoutNode, panel: string): PanelGroup | undefined =>
  groupsOf(node).find(({ panels }) => panels.includes(panel));
