import { type PointerEvent, type RefObject, useEffect, useRef, useState } from 'react';
import type { PanelDrop } from '../../layout/editLayout';
import type { PlacedGroup, Rectangle } from '../../layout/placeLayout';
import { useEditor } from '../../ui/EditorContext';
import { dropAt } from './dropAt';

/** Distance (CSS pixels) from which a press is a drag. */
const REACH = 6;

export interface TabDrag {
  readonly panel: string;
  readonly drop: PanelDrop | null;
  /** Rectangle that the panel would get; null where it cannot be dropped. */
  readonly mark: Rectangle | null;
}

/** Drags tabs by mouse, finger or pen. Escape cancels. */
export function useTabDrag(
  place: RefObject<HTMLElement | null>,
  groups: readonly PlacedGroup[],
): { current: TabDrag | null; begin(panel: string, event: PointerEvent): void } {
  const { layout } = useEditor();
  const [current, setCurrent] = useState<TabDrag | null>(null);
  const end = useRef<() => void>(() => {});
  const latest = useRef(groups);
  useEffect(() => {
    latest.current = groups;
  });
  useEffect(() => () => end.current(), []);

  const begin = (panel: string, down: PointerEvent): void => {
    if (down.button !== 0 || !down.isPrimary) return;
    end.current();
    let drag: TabDrag | null = null;
    const move = (event: globalThis.PointerEvent): void => {
      if (event.pointerId !== down.pointerId) return;
      if (!drag && Math.hypot(event.clientX - down.clientX, event.clientY - down.clientY) < REACH) return;
      const { left, top } = place.current!.getBoundingClientRect();
      const found = dropAt(latest.current, panel, event.clientX - left, event.clientY - top, place.current!);
      drag = { panel, drop: found?.drop ?? null, mark: found?.mark ?? null };
      setCurrent(drag);
      event.preventDefault();
    };
    const finish = (event: globalThis.PointerEvent): void => {
      if (event.pointerId !== down.pointerId) return;
      const done = drag;
      end.current();
      if (done?.drop) layout.move(panel, done.drop);
    };
    const key = (event: KeyboardEvent): void => {
      if (event.key !== 'Escape' || !drag) return;
      event.stopPropagation();
      end.current();
    };
    const cancel = (): void => end.current();
    window.addEventListener('pointermove', move);
    window.addEventListener('pointerup', finish);
    window.addEventListener('pointercancel', cancel);
    window.addEventListener('keydown', key, true);
    end.current = () => {
      end.current = () => {};
      window.removeEventListener('pointermove', move);
      window.removeEventListener('pointerup', finish);
      window.removeEventListener('pointercancel', cancel);
      window.removeEventListener('keydown', key, true);
      setCurrent(null);
    };
  };
  return { current, begin };
}
