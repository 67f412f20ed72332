import {
  type DropSide,
  groupsOf,
  groupWith,
  type LayoutNode,
  type LayoutSplit,
  MAIN_PANEL,
  type PanelGroup,
} from './LayoutNode';

/** Share of a group's extent that a panel put beside it takes. */
const BESIDE = 0.35;

type Direction = LayoutSplit['direction'];

/** Makes a split, merging nested splits of the same direction; a single child is returned as it is, null for none. */
function split(direction: Direction, children: readonly LayoutNode[], sizes: readonly number[]): LayoutNode | null {
  if (children.length < 2) return children[0] ?? null;
  const flat: LayoutNode[] = [];
  const flatSizes: number[] = [];
  children.forEach((child, i) => {
    if (child.kind === 'split' && child.direction === direction) {
      const sum = child.sizes.reduce((a, b) => a + b, 0);
      flat.push(...child.children);
      flatSizes.push(...child.sizes.map((size) => (size / sum) * sizes[i]));
    } else {
      flat.push(child);
      flatSizes.push(sizes[i]);
    }
  });
  return { kind: 'split', direction, children: flat, sizes: flatSizes };
}

/** Replaces each group of a layout; null removes it. */
function mapGroups(node: LayoutNode, change: (group: PanelGroup) => LayoutNode | null): LayoutNode | null {
  if (node.kind === 'group') return change(node);
  const kept = node.children.flatMap((child, i) => {
    const next = mapGroups(child, change);
    return next ? [{ next, size: node.sizes[i] }] : [];
  });
  return split(
    node.direction,
    kept.map(({ next }) => next),
    kept.map(({ size }) => size),
  );
}

/** Removes a panel; null when it was the last one. */
export function removePanel(layout: LayoutNode, panel: string): LayoutNode | null {
  return mapGroups(layout, (group) => {
    const at = group.panels.indexOf(panel);
    if (at < 0) return group;
    const panels = group.panels.filter((each) => each !== panel);
    if (panels.length === 0) return null;
    return { ...group, panels, active: group.active === panel ? panels[Math.max(0, at - 1)] : group.active };
  });
}

/** Brings a panel to the front of its group. */
export function activatePanel(layout: LayoutNode, panel: string): LayoutNode {
  return mapGroups(layout, (group) => (group.panels.includes(panel) ? { ...group, active: panel } : group))!;
}

/** A group id that is free in a layout. */
function freeId(layout: LayoutNode): string {
  const taken = new Set(groupsOf(layout).map(({ id }) => id));
  let n = 1;
  while (taken.has(`g${n}`)) n++;
  return `g${n}`;
}

export interface PanelDrop {
  /** Id of the group that the panel is put into, or beside. */
  readonly group: string;
  readonly side: DropSide;
  /** Index among the group's tabs; the end when absent. Only for 'centre'. */
  readonly index?: number;
  /** Width (left, right) or height of the group (CSS pixels), of which the panel takes a share. */
  readonly extent?: number;
}

/** Adds a panel, which is not in the layout yet, to a group or beside it. */
export function insertPanel(layout: LayoutNode, panel: string, drop: PanelDrop): LayoutNode {
  const id = freeId(layout);
  return mapGroups(layout, (group) => {
    if (group.id !== drop.group) return group;
    if (drop.side === 'centre') {
      return { ...group, panels: group.panels.toSpliced(drop.index ?? group.panels.length, 0, panel), active: panel };
    }
    return beside(group, { kind: 'group', id, panels: [panel], active: panel }, drop.side, drop.extent ?? 400);
  })!;
}

/** Puts a node at a side of another one. */
export function beside(
  node: LayoutNode,
  other: LayoutNode,
  side: Exclude<DropSide, 'centre'>,
  extent: number,
): LayoutNode {
  const direction = side === 'left' || side === 'right' ? 'row' : 'column';
  const isFirst = side === 'left' || side === 'top';
  const [large, small] = [extent * (1 - BESIDE), extent * BESIDE];
  return isFirst ? split(direction, [other, node], [small, large])! : split(direction, [node, other], [large, small])!;
}

/** Moves a panel of the layout. Nothing changes when it is dropped on the group that it alone forms. */
export function movePanel(layout: LayoutNode, panel: string, drop: PanelDrop): LayoutNode {
  const from = groupsOf(layout).find(({ panels }) => panels.includes(panel));
  if (from?.id === drop.group) {
    if (from.panels.length === 1) return layout;
    const at = from.panels.indexOf(panel);
    const index = drop.index !== undefined && drop.index > at ? drop.index - 1 : drop.index;
    return insertPanel(removePanel(layout, panel)!, panel, { ...drop, index });
  }
  return insertPanel(removePanel(layout, panel)!, panel, drop);
}

/** Sets the sizes of the split at a path of child indices. */
export function resizeSplit(layout: LayoutNode, path: readonly number[], sizes: readonly number[]): LayoutNode {
  if (layout.kind === 'group') return layout;
  const [first, ...rest] = path;
  if (first === undefined) return { ...layout, sizes };
  const child = resizeSplit(layout.children[first], rest, sizes);
  return { ...layout, children: layout.children.with(first, child) };
}

/** Grows a panel above or below the viewport to a minimum height (CSS pixels). */
export function growPanel(layout: LayoutNode, panel: string, least: number): LayoutNode {
  if (layout.kind === 'group') return layout;
  const at = layout.children.findIndex((child) => groupWith(child, panel));
  if (at < 0) return layout;
  const child = layout.children[at];
  if (layout.direction === 'row' || groupWith(child, MAIN_PANEL))
    return { ...layout, children: layout.children.with(at, growPanel(child, panel, least)) };
  return layout.sizes[at] < least ? { ...layout, sizes: layout.sizes.with(at, least) } : layout;
}
