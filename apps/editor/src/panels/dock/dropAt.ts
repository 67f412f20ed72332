import type { PanelDrop } from '../../layout/editLayout';
import type { DropSide } from '../../layout/LayoutNode';
import type { PlacedGroup, Rectangle } from '../../layout/placeLayout';
import { TAB_HEIGHT } from './tabHeight';

/** Width of a group's margins, as a share of its size; a panel dropped there is put beside the group, not into it. */
const MARGIN = 0.25;

function sideAt({ x, y, width, height }: Rectangle, px: number, py: number): DropSide {
  const [u, v] = [(px - x) / width, (py - y) / height];
  const nearest = Math.min(u, 1 - u, v, 1 - v);
  if (nearest > MARGIN) return 'centre';
  if (nearest === u) return 'left';
  if (nearest === 1 - u) return 'right';
  return nearest === v ? 'top' : 'bottom';
}

/** The half of a rectangle at a side; all of it for the centre. */
function partOf({ x, y, width, height }: Rectangle, side: DropSide): Rectangle {
  const [w, h] = [width / 2, height / 2];
  switch (side) {
    case 'left':
      return { x, y, width: w, height };
    case 'right':
      return { x: x + w, y, width: w, height };
    case 'top':
      return { x, y, width, height: h };
    case 'bottom':
      return { x, y: y + h, width, height: h };
    default:
      return { x, y, width, height };
  }
}

/**
 * Result of dropping a panel at a point of the dock (CSS pixels), and the rectangle to mark meanwhile; null when it
 * changes nothing.
 * @param dock - the element that contains the tabs
 */
export function dropAt(
  groups: readonly PlacedGroup[],
  panel: string,
  x: number,
  y: number,
  dock: HTMLElement,
): { drop: PanelDrop; mark: Rectangle } | null {
  const target = groups.find(({ rectangle: r }) => x >= r.x && x < r.x + r.width && y >= r.y && y < r.y + r.height);
  if (!target) return null;
  const { group, rectangle } = target;
  if (y < rectangle.y + TAB_HEIGHT) {
    const tabs = [...dock.querySelectorAll(`[data-group="${CSS.escape(group.id)}"] [data-panel]`)];
    const { left } = dock.getBoundingClientRect();
    const rectangles = tabs.map((tab) => tab.getBoundingClientRect());
    const found = rectangles.findIndex((each) => x + left < each.left + each.width / 2);
    const index = found < 0 ? tabs.length : found;
    const at = (index < tabs.length ? rectangles[index].left : (rectangles.at(-1)?.right ?? left)) - left;
    return {
      drop: { group: group.id, side: 'centre', index },
      mark: { x: at - 1, y: rectangle.y, width: 2, height: TAB_HEIGHT },
    };
  }
  const side = sideAt(rectangle, x, y);
  const isOwn = group.panels.includes(panel);
  // within its own group a panel can only be reordered, or moved to a side when other panels remain in it
  if (isOwn && (side === 'centre' || group.panels.length === 1)) return null;
  const extent = side === 'left' || side === 'right' ? rectangle.width : rectangle.height;
  return { drop: { group: group.id, side, extent }, mark: partOf(rectangle, side) };
}
