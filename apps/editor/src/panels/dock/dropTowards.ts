import type { PanelDrop } from '../../layout/editLayout';
import type { DropSide } from '../../layout/LayoutNode';
import type { PlacedGroup } from '../../layout/placeLayout';

type Side = Exclude<DropSide, 'centre'>;

/** Distance between rectangles facing each other; null when `to` is not at that side of `from`, or not opposite it. */
function distance(from: PlacedGroup['rectangle'], to: PlacedGroup['rectangle'], side: Side): number | null {
  const isRow = side === 'left' || side === 'right';
  const overlap = isRow
    ? Math.min(from.y + from.height, to.y + to.height) - Math.max(from.y, to.y)
    : Math.min(from.x + from.width, to.x + to.width) - Math.max(from.x, to.x);
  if (overlap <= 0) return null;
  const gap = {
    left: from.x - (to.x + to.width),
    right: to.x - (from.x + from.width),
    top: from.y - (to.y + to.height),
    bottom: to.y - (from.y + from.height),
  }[side];
  return gap >= 0 ? gap - overlap / 1e4 : null;
}

/**
 * Destination of a panel moved towards a side: the nearest group there, else a new group at that side of its group.
 * @returns null when it is already alone at that side
 */
export function dropTowards(groups: readonly PlacedGroup[], panel: string, side: Side): PanelDrop | null {
  const from = groups.find(({ group }) => group.panels.includes(panel));
  if (!from) return null;
  let nearest: PlacedGroup | null = null;
  let leastDistance = Infinity;
  for (const each of groups) {
    const gap = each === from ? null : distance(from.rectangle, each.rectangle, side);
    if (gap !== null && gap < leastDistance) [nearest, leastDistance] = [each, gap];
  }
  if (nearest) return { group: nearest.group.id, side: 'centre' };
  if (from.group.panels.length === 1) return null;
  const { width, height } = from.rectangle;
  return { group: from.group.id, side, extent: side === 'left' || side === 'right' ? width : height };
}
