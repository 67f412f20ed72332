import { lazy, type PointerEvent, type ReactNode, Suspense } from 'react';
import type { PanelGroup } from '../../layout/LayoutNode';
import type { PlacedGroup, Rectangle } from '../../layout/placeLayout';

// menus and their library come after the first frame
const TabStrip = lazy(async () => ({ default: (await import('./TabStrip')).TabStrip }));

interface DockGroupProps {
  readonly group: PanelGroup;
  readonly rectangle: Rectangle;
  /** All that are shown. */
  readonly groups: readonly PlacedGroup[];
  onDrag(panel: string, event: PointerEvent): void;
}

/** The place of a group: its tabs; what is below them lies over it. */
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
