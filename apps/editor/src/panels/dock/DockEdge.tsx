import { t } from '@farol/editing';
import { type KeyboardEvent, type PointerEvent, type ReactNode, useRef } from 'react';
import type { LayoutNode } from '../../layout/LayoutNode';
import { moveEdge, type PlacedEdge, SMALLEST } from '../../layout/placeLayout';
import type { PanelRegistry } from '../../layout/PanelRegistry';
import { useEditor } from '../../ui/EditorContext';

/** Distance (CSS pixels) that an arrow key moves an edge. */
const STEP = 16;

/** Title of the first panel at one side of a divider, for the divider's accessible name. */
function firstTitle(node: LayoutNode, panels: PanelRegistry): string {
  if (node.kind === 'split') return firstTitle(node.children[0], panels);
  return t(panels.get(node.active)?.title ?? node.active);
}

function splitAt(layout: LayoutNode, path: readonly number[]): LayoutNode {
  return path.reduce((node, i) => (node.kind === 'split' ? node.children[i] : node), layout);
}

/** Divider between two neighbouring parts of the dock, dragged or moved by arrow keys. */
export function DockEdge({ edge, layout }: { edge: PlacedEdge; layout: LayoutNode }): ReactNode {
  const { panels, layout: panelLayout } = useEditor();
  const { path, index, direction, rectangle, sizes } = edge;
  const isRow = direction === 'row';
  const split = splitAt(layout, path);
  const names =
    split.kind === 'split'
      ? [split.children[index], split.children[index + 1]].map((child) => firstTitle(child, panels))
      : [];
  const start = useRef({ pointer: -1, at: 0, edge });

  const pointerDown = (event: PointerEvent<HTMLDivElement>): void => {
    if (event.button !== 0) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    start.current = { pointer: event.pointerId, at: isRow ? event.clientX : event.clientY, edge };
  };
  const pointerMove = (event: PointerEvent): void => {
    const { pointer, at, edge: from } = start.current;
    if (event.pointerId !== pointer) return;
    panelLayout.resize(path, moveEdge(from, (isRow ? event.clientX : event.clientY) - at));
  };
  const pointerEnd = (): void => {
    start.current = { ...start.current, pointer: -1 };
  };
  const keyDown = (event: KeyboardEvent): void => {
    const steps: Record<string, number> = isRow
      ? { ArrowLeft: -STEP, ArrowRight: STEP }
      : { ArrowUp: -STEP, ArrowDown: STEP };
    const by = steps[event.key];
    if (by === undefined) return;
    event.preventDefault();
    panelLayout.resize(path, moveEdge(edge, by));
  };

  return (
    <div
      className="dock-edge"
      data-direction={direction}
      style={{ left: rectangle.x, top: rectangle.y, width: rectangle.width, height: rectangle.height }}
      role="separator"
      aria-orientation={isRow ? 'vertical' : 'horizontal'}
      aria-label={t('Edge between {first} and {second}', { first: names[0], second: names[1] })}
      aria-valuenow={sizes[index]}
      aria-valuemin={SMALLEST}
      aria-valuemax={Math.max(SMALLEST, sizes[index] + sizes[index + 1] - SMALLEST)}
      tabIndex={0}
      onPointerDown={pointerDown}
      onPointerMove={pointerMove}
      onPointerUp={pointerEnd}
      onLostPointerCapture={pointerEnd}
      onKeyDown={keyDown}
    />
  );
}
