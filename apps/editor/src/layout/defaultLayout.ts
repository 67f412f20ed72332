import type { LayoutNode, LayoutSplit, PanelGroup } from './LayoutNode';

export type PanelPlace = 'left' | 'middle' | 'right' | 'bottom';

/** What the layout needs to know of a panel. */
export interface PlacedPanel {
  readonly id: string;
  /** Where it is at first. */
  readonly place: PanelPlace;
  /** Whether it is there at first. */
  readonly isOpen?: boolean;
}

/** The group that a place is at first. */
export const groupOfPlace = (place: PanelPlace): string => place;

/**
 * A layout of the panels that are open at first, each at its place. Panels of one place share a group.
 * @param height - of the window (CSS pixels): in a low one the bottom takes less
 */
export function defaultLayout(panels: readonly PlacedPanel[], height = 900): LayoutNode {
  const sizes = { left: 250, right: 340, bottom: Math.min(190, Math.round(height * 0.22)) };
  const group = (place: PanelPlace): PanelGroup[] => {
    const ids = panels.filter((panel) => panel.place === place && panel.isOpen !== false).map(({ id }) => id);
    return ids.length === 0 ? [] : [{ kind: 'group', id: groupOfPlace(place), panels: ids, active: ids[0] }];
  };
  const stack = (direction: LayoutSplit['direction'], parts: [LayoutNode, number][]): LayoutNode =>
    parts.length === 1
      ? parts[0][0]
      : { kind: 'split', direction, children: parts.map(([node]) => node), sizes: parts.map(([, size]) => size) };
  const part = (place: 'left' | 'right' | 'bottom'): [LayoutNode, number][] =>
    group(place).map((node) => [node, sizes[place]]);
  const middle = group('middle').map((node): [LayoutNode, number] => [node, 500]);
  const columns: [LayoutNode, number][] = [...part('left'), [stack('column', [...middle, ...part('bottom')]), 800]];
  return stack('row', [...columns, ...part('right')]);
}
