import { Activity, createElement, memo, type ReactNode, Suspense, useState } from 'react';
import type { Rectangle } from '../../layout/placeLayout';
import { useEditor } from '../../ui/EditorContext';
import { PanelBoundary } from '../../ui/PanelBoundary';

interface DockPanelProps {
  readonly id: string;
  readonly isInFront: boolean;
  /** Rectangle of the panel in the dock (CSS pixels); null while another panel fills the window. */
  readonly rectangle: Rectangle | null;
}

const isSame = (a: DockPanelProps, b: DockPanelProps): boolean =>
  a.id === b.id &&
  a.isInFront === b.isInFront &&
  a.rectangle?.x === b.rectangle?.x &&
  a.rectangle?.y === b.rectangle?.y &&
  a.rectangle?.width === b.rectangle?.width &&
  a.rectangle?.height === b.rectangle?.height;

/** A panel at its place: fetched when first in front; its React effects are off while another panel covers it. */
export const DockPanel = memo(function DockPanel({ id, isInFront, rectangle }: DockPanelProps): ReactNode {
  const [wasInFront, setWasInFront] = useState(isInFront);
  if (isInFront && !wasInFront) setWasInFront(true);
  const { panels } = useEditor();
  const component = panels.componentOf(id);
  if (!component || !(isInFront || wasInFront)) return null;
  return (
    <div
      id={`panel-${id}`}
      className="dock-panel"
      role="tabpanel"
      aria-labelledby={`tab-${id}`}
      tabIndex={-1}
      hidden={!isInFront}
      style={
        rectangle
          ? { left: rectangle.x, top: rectangle.y, width: rectangle.width, height: rectangle.height }
          : undefined
      }
    >
      <Activity mode={isInFront ? 'visible' : 'hidden'}>
        <PanelBoundary>
          <Suspense fallback={null}>{createElement(component)}</Suspense>
        </PanelBoundary>
      </Activity>
    </div>
  );
}, isSame);
