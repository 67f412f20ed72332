import type { LayoutNode, LayoutSplit, PanelGroup } from './LayoutNode';

export type PanelPlace = 'left' | 'middle' | 'right' | 'bottom';

/** The properties of a panel that the layout depends on. */
export interface PlacedPanel {
  readonly id: string;
  readonly place: PanelPlace;
  readonly isOpen?: boolean;
  /** Smallest useful height (CSS pixels); no minimum when absent. */
  readonly height?: number;
}

/** Id of the group at a default place. */
export const groupOfPlace = (place: PanelPlace): string => place;

/** Width (CSS pixels) up to which an upright window has no space beside the viewport. */
const NARROW = 1000;

/**
 * The default layout: open panels at their default places, those of one place in a group. In a narrow upright window
 * the viewport has the full width, with the other panels below.
 * @param height - height of the window (CSS pixels), which determines the height of panels at the bottom
 * @param width - width of the window (CSS pixels), which determines the width of panels at the sides
 */
export function defaultLayout(panels: readonly PlacedPanel[], height = 900, width = 1440): LayoutNode {
  const between = (least: number, size: number, most: number): number =>
    Math.round(Math.min(most, Math.max(least, size)));
  const sizes = {
    left: between(250, width * 0.13, 340),
    right: between(340, width * 0.18, 460),
    bottom: between(0, height * 0.22, height < 1000 ? 190 : 320),
  };
  const group = (place: PanelPlace, ...more: PanelPlace[]): PanelGroup[] => {
    const open = panels.filter(({ isOpen }) => isOpen !== false);
    const ids = [place, ...more].flatMap((each) => open.filter((panel) => panel.place === each)).map(({ id }) => id);
    return ids.length === 0 ? [] : [{ kind: 'group', id: groupOfPlace(place), panels: ids, active: ids[0] }];
  };
  const stack = (direction: LayoutSplit['direction'], parts: [LayoutNode, number][]): LayoutNode =>
    parts.length === 1
      ? parts[0][0]
      : { kind: 'split', direction, children: parts.map(([node]) => node), sizes: parts.map(([, size]) => size) };
  const part = (place: 'left' | 'right' | 'bottom'): [LayoutNode, number][] =>
    group(place).map((node) => [node, sizes[place]]);
  if (width < Math.min(height, NARROW)) {
    const below: [LayoutNode, number][] = [...group('left', 'bottom'), ...group('right')].map((node) => [node, 400]);
    const parts: [LayoutNode, number][] = group('middle').map((node) => [node, 500]);
    if (below.length > 0) parts.push([stack('row', below), Math.round(height * 0.42)]);
    return stack('column', parts);
  }
  const middle = group('middle').map((node): [LayoutNode, number] => [node, 500]);
  const columns: [LayoutNode, number][] = [...part('left'), [stack('column', [...middle, ...part('bottom')]), 800]];
  return stack('row', [...columns, ...part('right')]);
}
