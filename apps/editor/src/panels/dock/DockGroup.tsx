import { lazy, type ReactNode, Suspense } from 'react';
import type { PanelGroup } from '../../layout/LayoutNode';
import type { PlacedGroup, Rectangle } from '../../layout/placeLayout';
import type { DragPlace } from './useTabDrag';

// the tab strip is fetched after the first frame, with the library of menus
const TabStrip = lazy(async () => ({ default: (await import('./TabStrip')).TabStrip }));

interface DockGroupProps {
  readonly group: PanelGroup;
  readonly rectangle: Rectangle;
  /** All visible groups, as targets for dragged tabs. */
  readonly groups: readonly PlacedGroup[];
  readonly place: DragPlace;
}

/** The tab strip of a group; its panel is drawn over the space below. */
export function DockGroup({ group, rectangle, groups, place }: DockGroupProps): ReactNode {
  const { x, y, width, height } = rectangle;
  return (
    <div className="dock-group" data-group={group.id} style={{ left: x, top: y, width, height }}>
      <Suspense fallback={<div className="tabs" />}>
        <TabStrip group={group} groups={groups} place={place} />
      </Suspense>
    </div>
  );
}
