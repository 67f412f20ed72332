import { groupWith, type LayoutNode, type LayoutSplit, MAIN_PANEL, type PanelGroup } from './LayoutNode';

/** Rectangle in CSS pixels from the upper left corner of the dock. */
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

/** Divider between two children of a split. */
export interface PlacedEdge {
  /** Path to the split: indices of children from the root. */
  readonly path: readonly number[];
  /** Index of the split's child before the divider. */
  readonly index: number;
  readonly direction: LayoutSplit['direction'];
  readonly rectangle: Rectangle;
  /** Present sizes of the split's children (CSS pixels). */
  readonly sizes: readonly number[];
}

/** Width of dividers between groups (CSS pixels). */
export const EDGE = 1;

/** Smallest width and height of a split's child (CSS pixels), if the window is large enough. */
export const SMALLEST = 120;

/**
 * Actual sizes of a split's children within `extent` (CSS pixels). The child with the viewport, or else the largest
 * one, takes the rest.
 */
export function sizesOf(split: LayoutSplit, extent: number): number[] {
  const room = Math.max(0, extent - EDGE * (split.children.length - 1));
  const main = split.children.findIndex((child) => groupWith(child, MAIN_PANEL));
  const flexible = main >= 0 ? main : split.sizes.indexOf(Math.max(...split.sizes));
  const others = split.sizes.reduce((sum, size, i) => (i === flexible ? sum : sum + size), 0);
  const smallest = Math.min(SMALLEST, room / split.children.length);
  const scale = others > room - smallest ? (room - smallest) / others : 1;
  const sizes = split.sizes.map((size) => Math.round(size * scale));
  sizes[flexible] = 0;
  sizes[flexible] = room - sizes.reduce((a, b) => a + b, 0);
  return sizes;
}

/** Rectangles of a layout's groups, and the dividers between them. */
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

/** Sizes of a split after a divider was moved. @param by - CSS pixels */
export function moveEdge({ sizes, index }: PlacedEdge, by: number): number[] {
  const smallestOf = (i: number): number => Math.min(SMALLEST, sizes[i]);
  const moved = Math.max(smallestOf(index) - sizes[index], Math.min(by, sizes[index + 1] - smallestOf(index + 1)));
  return sizes.map((size, i) => (i === index ? size + moved : i === index + 1 ? size - moved : size));
}
