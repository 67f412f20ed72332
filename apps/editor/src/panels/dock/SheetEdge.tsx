import { t } from '@farol/editing';
import type { KeyboardEvent, PointerEvent, ReactNode } from 'react';
import type { PlacedSheet } from '../../layout/smallWindow';
import { useEditor } from '../../ui/EditorContext';

/** Step of an arrow key, as a share of the dock. */
const STEP = 0.05;

export interface SheetEdgeProps {
  readonly placed: PlacedSheet;
  /** Share of the dock that the panel covers, 0 to 1. */
  readonly share: number;
  /** Size of the dock (CSS pixels). */
  readonly width: number;
  readonly height: number;
}

/** Divider between the viewport and the panel in a small window, dragged or moved by arrow keys. */
export function SheetEdge({ placed, share, width, height }: SheetEdgeProps): ReactNode {
  const { layout } = useEditor();
  const { edge, tabs, isBelow } = placed;
  if (!edge) return null;
  const extent = isBelow ? height - tabs.height : width;
  const drag = (event: PointerEvent<HTMLDivElement>): void => {
    if (!event.currentTarget.hasPointerCapture(event.pointerId)) return;
    const { left, top } = event.currentTarget.parentElement!.getBoundingClientRect();
    const at = isBelow ? event.clientY - top : event.clientX - left;
    layout.shareSheet((extent - at) / extent);
  };
  const keyDown = (event: KeyboardEvent): void => {
    const by = { ArrowUp: STEP, ArrowLeft: STEP, ArrowDown: -STEP, ArrowRight: -STEP }[event.key];
    if (by === undefined) return;
    layout.shareSheet(share + by);
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    // oxlint-disable-next-line jsx-a11y/no-noninteractive-element-interactions -- a separator with a value is a control
    <div
      className="sheet-edge"
      role="separator"
      // oxlint-disable-next-line jsx-a11y/no-noninteractive-tabindex -- a separator with a value is a control
      tabIndex={0}
      aria-label={t('Size of the panel')}
      aria-orientation={isBelow ? 'horizontal' : 'vertical'}
      aria-valuenow={Math.round(share * 100)}
      aria-valuemin={20}
      aria-valuemax={80}
      style={{ left: edge.x, top: edge.y, width: edge.width, height: edge.height }}
      onPointerDown={(event) => event.currentTarget.setPointerCapture(event.pointerId)}
      onPointerMove={drag}
      onKeyDown={keyDown}
    />
  );
}
