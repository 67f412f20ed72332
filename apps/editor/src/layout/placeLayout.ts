import { groupWith, type LayoutNode, type LayoutSplit, MAIN_PANEL, type PanelGroup } from './LayoutNode';

/** In CSS pixels, from the left top corner of the window's dock. */
export interface Rectangle {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

export interface PlacedGroup {
  readonly group: PanelGroup;
  readonly rectangle: Rectangle;
}

/** The line between two children of a split, which can be dragged. */
export interface PlacedEdge {
  /** Of the split: indices of children from the root. */
  readonly path: readonly number[];
  /** Of the child before the line. */
  readonly index: number;
  readonly direction: LayoutSplit['direction'];
  readonly rectangle: Rectangle;
  /** What the children of the split take now (CSS pixels). */
  readonly sizes: readonly number[];
}

/** Width of the lines between groups (CSS pixels). */
export const EDGE = 1;

/** Least width and height of a place (CSS pixels), as far as the window is large enough. */
export const SMALLEST = 120;

/** What each child of a split takes of `extent`. The child with the viewport, or else the largest one, takes the rest. */
export function sizesOf(split: LayoutSplit, extent: number): number[] {
  const room = Math.max(0, extent - EDGE * (split.children.length - 1));
  const main = split.children.findIndex((child) => groupWith(child, MAIN_PANEL));
  const flexible = main >= 0 ? main : split.sizes.indexOf(Math.max(...split.sizes));
  const others = split.sizes.reduce((sum, size, i) => (i === flexible ? sum : sum + size), 0);
  const least = Math.min(SMALLEST, room / split.children.length);
  const scale = others > room - least ? (room - least) / others : 1;
  const sizes = split.sizes.map((size) => Math.round(size * scale));
  sizes[flexible] = 0;
  sizes[flexible] = room - sizes.reduce((a, b) => a + b, 0);
  return sizes;
}

/** Where the groups of a layout are, and the lines between them. */
export function placeLayout(
  layout: LayoutNode,
  width: number,
  height: number,
): { groups: PlacedGroup[]; edges: PlacedEdge[] } {
  const groups: PlacedGroup[] = [];
  const edges: PlacedEdge[] = [];
  const visit = (node: LayoutNode, { x, y, width: w, height: h }: Rectangle, path: readonly number[]): void => {
    if (node.kind === 'group') {
      groups.push({ group: node, rectangle: { x, y, width: w, height: h } });
      return;
    }
    const isRow = node.direction === 'row';
    const sizes = sizesOf(node, isRow ? w : h);
    let at = isRow ? x : y;
    node.children.forEach((child, i) => {
      const size = sizes[i];
      visit(child, isRow ? { x: at, y, width: size, height: h } : { x, y: at, width: w, height: size }, [...path, i]);
      at += size;
      if (i === node.children.length - 1) return;
      const rectangle = isRow ? { x: at, y, width: EDGE, height: h } : { x, y: at, width: w, height: EDGE };
      edges.push({ path, index: i, direction: node.direction, rectangle, sizes });
      at += EDGE;
    });
  };
  visit(layout, { x: 0, y: 0, width, height }, []);
  return { groups, edges };
}

/** The sizes of a split after the line behind child `index` was moved by some pixels. */
export function moveEdge({ sizes, index }: PlacedEdge, by: number): number[] {
  const least = (i: number): number => Math.min(SMALLEST, sizes[i]);
  const moved = Math.max(least(index) - sizes[index], Math.min(by, sizes[index + 1] - least(index + 1)));
  return sizes.map((size, i) => (i === index ? size + moved : i === index + 1 ? size - moved : size));
}
