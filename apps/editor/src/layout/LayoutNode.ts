/** A group of panels in one place, one of them in front. */
export interface PanelGroup {
  readonly kind: 'group';
  /** Id of the group, unique within a layout. */
  readonly id: string;
  /** Ids of panels, in the order of their tabs; at least one. */
  readonly panels: readonly string[];
  /** Id of the group's panel in front. */
  readonly active: string;
}

/** Groups or splits that are arranged side by side ('row') or one above the other ('column'). */
export interface LayoutSplit {
  readonly kind: 'split';
  readonly direction: 'row' | 'column';
  /** The split's parts: at least two, none of them a split in the same direction. */
  readonly children: readonly LayoutNode[];
  /** Preferred width or height of each child (CSS pixels). The child with the viewport gets the remaining space. */
  readonly sizes: readonly number[];
}

/** Arrangement of the panels in the window: a tree of splits and groups. */
export type LayoutNode = PanelGroup | LayoutSplit;

/** Side of a group where a panel is dropped: into the group, or beside it. */
export type DropSide = 'centre' | 'left' | 'right' | 'top' | 'bottom';

/** Id of the panel that gets the space left by the other panels. */
export const MAIN_PANEL = 'viewport';

/** All groups of a layout, from left to right and from top to bottom. */
export function groupsOf(node: LayoutNode): PanelGroup[] {
  return node.kind === 'group' ? [node] : node.children.flatMap(groupsOf);
}

export const groupWith = (node: LayoutNode, panel: string): PanelGroup | undefined =>
  groupsOf(node).find(({ panels }) => panels.includes(panel));
