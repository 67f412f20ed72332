import type { ClipGesture, Timeline } from '../../model/timeline/Timeline';

/** Handler of a press and its drag. Positions are CSS pixels of the canvas. */
export interface SheetDrag {
  /** Called when the press becomes a drag. */
  begin?(): void;
  move(x: number, y: number, event: PointerEvent): void;
  /** @param keeps - whether the drag's result is kept; false when it is cancelled */
  end(keeps: boolean): void;
  /** Called when the pointer is released without a drag. */
  click?(event: PointerEvent): void;
}

/** A drag that edits the clip: previewed while it moves, and committed as one step of history at the end. */
export function editDrag(
  timeline: Timeline,
  preview: (gesture: ClipGesture, x: number, y: number, event: PointerEvent) => void,
): SheetDrag {
  let gesture: ClipGesture | null = null;
  return {
    begin: () => (gesture = timeline.beginEdit()),
    move: (x, y, event) => gesture && preview(gesture, x, y, event),
    end: (keeps) => (keeps ? gesture?.commit() : gesture?.discard()),
  };
}
