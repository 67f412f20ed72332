import { type DragEvent, type HTMLAttributes, useState } from 'react';

/**
 * Properties of an element that accepts drops; `data-drop` is 'true' while accepted data is dragged over it.
 * @param accepts - whether dragged data are accepted, judged by their types: contents cannot be read before the drop
 */
export function useDropTarget(
  accepts: (dragged: DataTransfer) => boolean,
  dropped: (data: DataTransfer) => void,
): HTMLAttributes<HTMLElement> {
  const [isOver, setOver] = useState(false);
  const take = (event: DragEvent, isDrop: boolean): void => {
    const isTaken = accepts(event.dataTransfer);
    setOver(isTaken && !isDrop);
    if (!isTaken) return;
    event.preventDefault();
    event.stopPropagation();
    if (isDrop) dropped(event.dataTransfer);
    else event.dataTransfer.dropEffect = 'copy';
  };
  return {
    ...{ 'data-drop': isOver, onDragLeave: () => setOver(false) },
    onDragOver: (event) => take(event, false),
    onDrop: (event) => take(event, true),
  };
}
