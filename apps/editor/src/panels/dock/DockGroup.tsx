import { lazy, type PointerEvent, type ReactNode, Suspense } from 'react';
import type { PanelGroup } from '../../layout/LayoutNode';
import type { PlacedGroup, Rectangle } from '../../layout/placeLayout';

// fetched after the first frame, with the library of menus
const TabStrip = lazy(async () => ({ default: (await import('./TabStrip')).TabStrip }));

interface DockGroupProps {
  readonly group: PanelGroup;
  readonly rectangle: Rectangle;
  /** All visible groups, as targets for dragged tabs. */
  readonly groups: readonly PlacedGroup[];
  onDrag(panel: string, event: PointerEvent): void;
}

/** The tab strip of a group; its panel is drawn over the space below. */
export function DockGroup({ group, rectangle, groups, onDrag }: DockGroupProps): ReactNode {
  const { x, y, width, height } = rectangle;
  return (
    <div className="dock-group" data-group={group.id} style={{ left: x, top: y, width, height }}>
      <Suspense fallback={<div className="tabs" />}>
        <TabStrip group={group} groups={groups} onDrag={onDrag} />
      </Suspense>
    </div>
  );
}
