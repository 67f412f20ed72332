import type { KeyboardEvent, PointerEvent, ReactNode } from 'react';

interface ResizeHandleProps {
  /** What it makes wider and narrower. */
  readonly label: string;
  readonly width: number;
  readonly min: number;
  readonly max: number;
  /** The side of the handle that the panel is on. */
  readonly side: 'left' | 'right';
  onChange(width: number): void;
}

/** The edge of a panel, which can be dragged, or moved by the arrow keys. */
export function ResizeHandle({ label, width, min, max, side, onChange }: ResizeHandleProps): ReactNode {
  const sign = side === 'left' ? 1 : -1;
  const set = (next: number): void => onChange(Math.min(max, Math.max(min, Math.round(next))));

  const pointerDown = (event: PointerEvent<HTMLDivElement>): void => {
    const { currentTarget: handle, pointerId, clientX } = event;
    handle.setPointerCapture(pointerId);
    const move = (moved: globalThis.PointerEvent): void => set(width + sign * (moved.clientX - clientX));
    handle.addEventListener('pointermove', move);
    handle.addEventListener('lostpointercapture', () => handle.removeEventListener('pointermove', move), {
      once: true,
    });
  };
  const keyDown = (event: KeyboardEvent): void => {
    const step = { ArrowLeft: -16, ArrowRight: 16 }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    set(width + sign * step);
  };

  return (
    <div
      className={`resize-handle ${side}`}
      role="separator"
      aria-orientation="vertical"
      aria-label={label}
      aria-valuenow={width}
      aria-valuemin={min}
      aria-valuemax={max}
      tabIndex={0}
      onPointerDown={pointerDown}
      onKeyDown={keyDown}
    />
  );
}
