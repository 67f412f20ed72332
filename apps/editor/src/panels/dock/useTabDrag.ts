import { type PointerEvent, type RefObject, useEffect, useRef } from 'react';
import type { PanelDrop } from '../../layout/editLayout';
import type { PlacedGroup, Rectangle } from '../../layout/placeLayout';
import { useEditor } from '../../ui/EditorContext';
import { dropAt } from './dropAt';

/** Distance (CSS pixels) beyond which a press becomes a drag. */
const REACH = 6;

/** The dock in which tabs are dragged. */
export interface DragPlace {
  readonly dock: RefObject<HTMLElement | null>;
  /** Marks the rectangle that a dragged panel would get; null where it cannot be dropped. */
  onMark(mark: Rectangle | null): void;
}

/** Drags tabs by mouse, finger or pen. Escape cancels. @returns the handler that begins a drag when a tab is pressed */
export function useTabDrag(
  groups: readonly PlacedGroup[],
  { dock, onMark }: DragPlace,
): (panel: string, event: PointerEvent) => void {
  const { layout } = useEditor();
  const end = useRef<() => void>(() => {});
  const latest = useRef(groups);
  useEffect(() => {
    latest.current = groups;
  });
  useEffect(() => () => end.current(), []);

  return (panel, down) => {
    if (down.button !== 0 || !down.isPrimary) return;
    end.current();
    let isDragged = false;
    let drop: PanelDrop | null = null;
    const move = (event: globalThis.PointerEvent): void => {
      if (event.pointerId !== down.pointerId) return;
      if (!isDragged && Math.hypot(event.clientX - down.clientX, event.clientY - down.clientY) < REACH) return;
      isDragged = true;
      const { left, top } = dock.current!.getBoundingClientRect();
      const found = dropAt(latest.current, panel, event.clientX - left, event.clientY - top, dock.current!);
      drop = found?.drop ?? null;
      onMark(found?.mark ?? null);
      event.preventDefault();
    };
    const finish = (event: globalThis.PointerEvent): void => {
      if (event.pointerId !== down.pointerId) return;
      end.current();
      if (drop) layout.move(panel, drop);
    };
    const key = (event: KeyboardEvent): void => {
      if (event.key !== 'Escape' || !isDragged) return;
      event.stopPropagation();
      end.current();
    };
    const cancel = (): void => end.current();
    const listening = new AbortController();
    const { signal } = listening;
    window.addEventListener('pointermove', move, { signal });
    window.addEventListener('pointerup', finish, { signal });
    window.addEventListener('pointercancel', cancel, { signal });
    window.addEventListener('keydown', key, { capture: true, signal });
    end.current = () => {
      end.current = () => {};
      listening.abort();
      onMark(null);
    };
  };
}
